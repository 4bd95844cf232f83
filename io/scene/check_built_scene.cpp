// SPDX-License-Identifier: Apache-2.0
#include "io/scene/check_built_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "io/scene/read_scene.hpp"
#include "io/scene/tables/read_sections.hpp"

namespace thaw {
namespace {

/// Gives names to elements without one, so that they are not taken for duplicates.
template<class T> void nameAll(std::vector<T>& list) {
  for (std::size_t k = 0; k < list.size(); k++)
    if (list[k].name.empty()) list[k].name = std::to_string(k);
}

class BuiltSceneCheck {
 public:
  BuiltSceneCheck(Scene scene, const std::string& name) : scene_(std::move(scene)), name_(name) {}

  void run() {
    nameElements();
    std::vector<SceneError> errors;
    addReferences(errors);
    if (errors.empty()) errors = valueErrors(scene_);
    addDomain(errors);
    if (errors.empty()) {
      reading_.scene = &scene_;
      reading_.start = {name_, 0, 0};
      reading_.domain = reading_.spacing = reading_.start;
      const std::vector<std::uint8_t> given(scene_.materials.size(), 0);
      reading_.open = {false, false, false, false, false, false, given, given};
      checkScene(reading_, errors);
    }
    if (errors.empty()) return;
    std::vector<std::string> lines;
    for (const SceneError& e : errors)
      if (const std::string line = lineOf(e); std::find(lines.begin(), lines.end(), line) == lines.end())
        lines.push_back(line);
    throw SceneErrors(lines);
  }

 private:
  void nameElements() {
    nameAll(scene_.materials);
    nameAll(scene_.bodies);
    nameAll(scene_.oriented);
    nameAll(scene_.sheets);
    nameAll(scene_.emitters);
    nameAll(scene_.obstacles);
    nameAll(scene_.lamps);
    nameAll(scene_.lasers);
    nameAll(scene_.heatedRegions);
  }

  /// Collects the names of materials, which the reader's checks use. Adds an error for each missing material.
  template<class T>
  void refer(const std::vector<T>& list, const std::string& what, std::vector<MaterialName>& names, bool all,
             std::vector<SceneError>& errors) const {
    const int n = static_cast<int>(scene_.materials.size());
    for (std::size_t k = 0; k < list.size(); k++) {
      const int m = list[k].material;
      if (m >= 0 && m < n) {
        names.push_back({scene_.materials[static_cast<std::size_t>(m)].name, list[k].where});
        continue;
      }
      names.push_back({"", list[k].where});
      if (all && m == -1) continue;
      std::string owner = what + "." + std::to_string(k);
      if constexpr (requires { list[k].name; }) owner = what + "." + list[k].name;
      errors.push_back({list[k].where, fmt::format("{}.material: expected the number of a material, of which "
                                                   "the scene has {}, got {}",
                                                   owner, n, m)});
    }
  }

  void addReferences(std::vector<SceneError>& errors) {
    refer(scene_.bodies, "body", reading_.bodyMaterials, false, errors);
    refer(scene_.emitters, "emitter", reading_.emitterMaterials, false, errors);
    refer(scene_.thermostats, "thermostat", reading_.thermostatMaterials, true, errors);
    refer(scene_.heatedRegions, "heated_region", reading_.regionMaterials, true, errors);
  }

  void addDomain(std::vector<SceneError>& errors) const {
    const Domain& d = scene_.domain;
    for (int a = 0; a < 3; a++) {
      if (!(d.max[a] > d.min[a]))
        errors.push_back({{}, fmt::format("domain.max: must exceed domain.min along {}", "xyz"[a])});
      if ((d.side[a][0] == Side::Periodic) != (d.side[a][1] == Side::Periodic))
        errors.push_back(
            {{}, fmt::format("domain.sides.{}: expected both sides to be periodic, or none", "xyz"[a])});
    }
  }

  std::string lineOf(const SceneError& e) const {
    if (e.where.line > 0)
      return fmt::format("{}:{}:{}: error: {}", e.where.file, e.where.line, e.where.column, e.text);
    return fmt::format("{}: error: {}", name_, e.text);
  }

  Scene scene_;
  const std::string& name_;
  SceneReading reading_;
};

}  // namespace

void checkBuiltScene(Scene scene, const std::string& name) {
  try {
    BuiltSceneCheck(std::move(scene), name).run();
  } catch (const std::invalid_argument& e) {  // a choice with an unknown value
    throw SceneErrors({fmt::format("{}: error: {}", name, e.what())});
  }
}

}  // namespace thaw
