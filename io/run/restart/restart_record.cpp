// SPDX-License-Identifier: Apache-2.0
#include "io/run/restart/restart_record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <functional>

#include "core/materials/liquid_materials.hpp"
#include "core/scene/expected_speeds.hpp"
#include "io/scene/tables/read_sections.hpp"
#include "io/scene/text/value_text.hpp"

namespace thaw {
namespace {

/// Entries of a record by their stored key: the effect of a change, and the path in the scene.
using Record = std::map<std::string, KeyDescription>;

const char* prefixOf(Restart effect) {
  switch (effect) {
    case Restart::State: return "state.";
    case Restart::Coefficient: return "coefficient.";
    case Restart::Setting: return "setting.";
    case Restart::Start: return "start.";
    case Restart::Free: break;
  }
  return "";
}

Record recordOf(const Scene& s) {
  std::vector<KeyDescription> keys = sceneValues(s);
  // Automatic sound speeds follow from the expected speed, which also depends on the initial state of bodies.
  if (std::ranges::any_of(s.materials, [](const Material& m) { return canBeLiquid(m) && m.soundSpeed == 0; }))
    keys.push_back({"numerics", "expected_speed", "m/s", "", numberText(expectedFlow(s).speed), "",
                    Restart::Coefficient});
  Record record;
  for (KeyDescription& k : keys) {
    const std::string path = k.table.empty() ? k.key : k.table + "." + k.key;
    record[prefixOf(*k.restart) + path] = std::move(k);
  }
  return record;
}

/// Returns a value whose decimal fractions are rounded to six digits. Quoted texts stay as they are.
std::string roundedFractions(const std::string& value) {
  constexpr const char* numeric = "+-.0123456789e";
  std::string text;
  bool quote = false;
  for (std::size_t k = 0; k < value.size();) {
    quote ^= value[k] == '"';
    const std::size_t end = std::min(value.find_first_not_of(numeric, k), value.size());
    const std::string number = value.substr(k, end - k);
    const bool fraction = !quote && number.find('.') != std::string::npos &&
                          (k == 0 || !std::isalnum(static_cast<unsigned char>(value[k - 1])));
    text += fraction         ? fmt::format("{:.6g}", std::strtod(number.c_str(), nullptr))
            : number.empty() ? value.substr(k, 1)
                             : number;
    k = std::max(end, k + 1);
  }
  return text;
}

/// Returns "0.01 -> 0.02 m", or "0.01 m -> "never"". Values that rounding makes equal have all digits.
std::string changeText(const std::string& was, const std::string& is, const std::string& unit) {
  const std::string then = roundedFractions(was), now = roundedFractions(is),
                    ofNumber = unit.empty() ? "" : " " + unit;
  const bool word = is.starts_with('"');
  return (then == now ? was : then) + (word ? ofNumber : "") + " -> " + (then == now ? is : now) +
         (word ? "" : ofNumber);
}

/// Returns the changes of entries of one effect whose keys are chosen.
std::vector<std::string> changesOf(Restart effect, const CheckpointValues& stored, const Record& now,
                                   const std::function<bool(const std::string&)>& chosen) {
  const std::string prefix = prefixOf(effect);
  const bool values = effect != Restart::State;  // entries that only one scene has come with their value
  std::vector<std::string> changes;
  for (const auto& [key, was] : stored) {
    if (!key.starts_with(prefix) || !chosen(key)) continue;
    const std::string path = key.substr(prefix.size());
    const auto is = now.find(key);
    if (is == now.end())
      changes.push_back(
          path + (values ? ": " + changeText(was, "not in the scene", "") : " is not in the scene any more"));
    else if (is->second.standard != was)
      changes.push_back(path + ": " + changeText(was, is->second.standard, is->second.unit));
  }
  for (const auto& [key, is] : now)
    if (key.starts_with(prefix) && chosen(key) && !stored.contains(key))
      changes.push_back(key.substr(prefix.size()) +
                        (values ? ": " + changeText("not in the scene", is.standard, is.unit)
                                : " was not in the scene then"));
  return changes;
}

bool any(const std::string&) { return true; }

/// Returns whether a key belongs to an event that was before `time` in all records that have it.
bool isPastEvent(const std::string& key, const CheckpointValues& stored, const Record& now, double time) {
  const std::size_t at = key.rfind(".event.");
  if (at == std::string::npos) return false;
  const std::string timeKey = key.substr(0, key.find('.', at + 7)) + ".time";
  const auto was = stored.find(timeKey);
  const auto is = now.find(timeKey);
  const auto past = [&](const std::string& text) { return std::strtod(text.c_str(), nullptr) <= time; };
  return (was != stored.end() || is != now.end()) && (was == stored.end() || past(was->second)) &&
         (is == now.end() || past(is->second.standard));
}

}  // namespace

CheckpointValues restartRecordOf(const Scene& scene) {
  CheckpointValues values;
  for (const auto& [key, k] : recordOf(scene)) values[key] = k.standard;
  return values;
}

std::vector<std::string> restartConflicts(const CheckpointValues& stored, const Scene& scene) {
  return changesOf(Restart::State, stored, recordOf(scene), any);
}

std::vector<std::string> coefficientChanges(const CheckpointValues& stored, const Scene& scene) {
  return changesOf(Restart::Coefficient, stored, recordOf(scene), any);
}

std::vector<std::string> settingChanges(const CheckpointValues& stored, const Scene& scene, double time) {
  const Record now = recordOf(scene);
  return changesOf(Restart::Setting, stored, now,
                   [&](const std::string& key) { return !isPastEvent(key, stored, now, time); });
}

std::vector<std::string> pastEventChanges(const CheckpointValues& stored, const Scene& scene, double time) {
  const Record now = recordOf(scene);
  return changesOf(Restart::Setting, stored, now,
                   [&](const std::string& key) { return isPastEvent(key, stored, now, time); });
}

std::vector<std::string> initialStateChanges(const CheckpointValues& stored, const Scene& scene) {
  return changesOf(Restart::Start, stored, recordOf(scene), any);
}

std::string placeOfRecordKey(const Scene& scene, const std::string& text) {
  std::size_t longest = 0;
  SourcePlace where;
  for (const KeyDescription& k : sceneValues(scene))
    if (k.where.line > 0 && k.table.size() > longest && text.starts_with(k.table + ".")) {
      longest = k.table.size();
      where = k.where;
    }
  return where.line > 0 ? fmt::format(" ({}:{})", where.file, where.line) : "";
}

}  // namespace thaw
