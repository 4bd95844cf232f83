#include "io/scene/scene_warnings.hpp"

#include <fmt/format.h>

namespace thaw {
namespace {

std::string at(const SourcePlace& where) {
  return where.line > 0 && where.file.rfind("--set", 0) != 0 ? fmt::format("{}:{}:{}", where.file, where.line, where.column) : where.file;
}

}  // namespace

std::vector<std::string> sceneWarnings(const Scene& s) {
  std::vector<std::string> lines;
  for (const OrientedBody& b : s.oriented)
    for (const OrientedEvent& e : b.events)
      if (e.time > s.end) lines.push_back(fmt::format("{}: oriented body '{}': this event is at {:g} s and the scene ends at {:g} s: it does not happen", at(e.where), b.name, e.time, s.end));
  if (s.output.fieldsWhere.line > 0 && s.bodies.empty() && s.emitters.empty()) {
    std::string names;
    for (const std::string& name : s.output.fields) names += (names.empty() ? "" : ", ") + name;
    lines.push_back(fmt::format("{}: output.fields ({}) are of bodies and emitters, and the scene has none; frames of oriented bodies and sheets have all their fields", at(s.output.fieldsWhere), names));
  }
  return lines;
}

}  // namespace thaw
