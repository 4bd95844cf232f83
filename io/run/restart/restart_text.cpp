// SPDX-License-Identifier: Apache-2.0
#include "io/run/restart/restart_text.hpp"

#include <fmt/format.h>

#include <cctype>

#include "io/scene/tables/read_sections.hpp"
#include "io/scene/tables/read_shape.hpp"

namespace thaw {
namespace {

/// The parts before the first dot and after the last one. Names of bodies between them may have dots.
std::string firstOf(const std::string& key) { return key.substr(0, key.find('.')); }
std::string lastOf(const std::string& key) { return key.substr(key.rfind('.') + 1); }

/// Returns whether a key belongs to an event itself ("oriented.film.event.0.kind") and not to the shape of
/// its region.
bool isEventKey(const std::string& key) {
  std::size_t at = key.rfind('.');
  while (at != std::string::npos && at > 0 && std::isdigit(static_cast<unsigned char>(key[at - 1]))) at--;
  return at != std::string::npos && at >= 7 && key.compare(at - 7, 7, ".event.") == 0;
}

}  // namespace

RestartRecordText::RestartRecordText(const CheckpointValues& record) : record_(record) {
  for (const KeyDescription& k : sceneKeys())
    if (!k.words.empty()) words_[firstOf(k.table) + " " + k.key] = k.words;
  // A body has one of several keys.
  words_["oriented source"] = {"a shape", "patch", "disc", "points", "control", "curve"};
  words_["oriented tool"] = {"plane", "stroke", "a shape"};
  words_["oriented everywhere"] = {"false", "true"};
  words_["sheet mesh"] = sheetMeshWords();
}

/// Returns whether a key is a group and a name, as "material.wax", whose value is a place in a list. Keys of
/// coefficients have a prefix.
bool RestartRecordText::named(const std::string& key) {
  const std::string group = firstOf(key);
  if (group.size() == key.size()) return false;
  if (group == "material") return true;
  return (group == "body" || group == "emitter" || group == "oriented" || group == "sheet") &&
         key.find('.', group.size() + 1) == std::string::npos;
}

const std::vector<std::string>* RestartRecordText::wordsOf(const std::string& key) const {
  static const std::vector<std::string> flags{"false", "true"}, shapes = shapeWords();
  if (isName(key)) return nullptr;
  if (key.starts_with("domain.periodic.")) return &flags;
  const std::string last = lastOf(key);
  if (last == "kind" && !isEventKey(key)) return &shapes;
  const auto it = words_.find(firstOf(key) + " " + last);
  return it == words_.end() ? nullptr : &it->second;
}

std::string RestartRecordText::nameOf(const std::string& group, double place) const {
  for (const auto& [key, value] : record_)
    if (value == place && key.starts_with(group + ".") && named(key))
      return "\"" + key.substr(group.size() + 1) + "\"";
  return place < 0 ? "none" : fmt::format("number {} of the list", place);
}

std::string RestartRecordText::text(const std::string& key, double value) const {
  const std::string last = lastOf(key);
  if (!isName(key) && (last == "material" || (last == "other" && isEventKey(key))))
    return nameOf(last == "material" ? "material" : "oriented", value);
  const std::vector<std::string>* words = wordsOf(key);
  if (value == never) return "\"never\"";
  if (!words || !(value >= 0 && value < static_cast<double>(words->size()))) return fmt::format("{}", value);
  const std::string& word = (*words)[static_cast<std::size_t>(value)];
  return word == "false" || word == "true" ? word : "\"" + word + "\"";
}

std::string RestartRecordText::key(const std::string& mark) const {
  const std::size_t at = mark.rfind(".points");
  if (at == std::string::npos || firstOf(mark) != "oriented" ||
      (mark.substr(at) != ".points" && mark.substr(at) != ".points.checksum"))
    return mark;
  const auto source = record_.find(mark.substr(0, at) + ".source");
  return source != record_.end() && source->second == static_cast<double>(OrientedSource::Control)
             ? mark.substr(0, at) + ".control" + mark.substr(at + 7)
             : mark;
}

std::string RestartRecordText::unit(const std::string& key) const {
  if (isName(key)) return " (place in the list)";
  const std::string last = lastOf(key);
  if (last.starts_with("mesh_")) return last == "mesh_checksum" ? " (checksum of the mesh's file)" : "";
  if (last.ends_with("_expression")) return " (checksum of the text)";
  return wordsOf(key) || last == "material" || (last == "other" && isEventKey(key)) ? "" : " (SI)";
}

}  // namespace thaw
