// SPDX-License-Identifier: Apache-2.0
#include "io/scene/check_built_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <stdexcept>

#include "core/terms/extensions.hpp"
#include "io/scene/read_scene.hpp"
#include "io/scene/tables/read_sections.hpp"
#include "io/scene/text/path_names.hpp"

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
    std::map<const TermTable*, std::size_t> count;
    eachTermElement(scene_, [&](const Extension&, const TermTable& table, const TermElement& one) {
      const std::size_t k = count[&table]++;
      if (one.name && one.name->empty()) *one.name = std::to_string(k);
    });
  }

  /// Returns the name of a material, which the reader's checks use. Adds an error for a missing one. all: -1
  /// stands for all materials.
  MaterialName refer(int m, const SourcePlace& where, const std::string& owner, bool all,
                     std::vector<SceneError>& errors) const {
    const int n = static_cast<int>(scene_.materials.size());
    if (m >= 0 && m < n) return {scene_.materials[static_cast<std::size_t>(m)].name, where};
    if (!all || m != -1)
      errors.push_back({where, fmt::format("{}.material: expected the number of a material, of which the "
                                           "scene has {}, got {}",
                                           owner, n, m)});
    return {"", where};
  }

  void addReferences(std::vector<SceneError>& errors) {
    for (const Body& b : scene_.bodies)
      reading_.bodyMaterials.push_back(refer(b.material, b.where, "body." + b.name, false, errors));
    for (const Emitter& e : scene_.emitters)
      reading_.emitterMaterials.push_back(refer(e.material, e.where, "emitter." + e.name, false, errors));
    std::map<const TermTable*, std::size_t> count;
    eachTermElement(scene_, [&](const Extension&, const TermTable& table, const TermElement& one) {
      const std::size_t k = count[&table]++;
      if (!one.material) return;
      const std::string owner = std::string(table.key) + "." + (one.name ? *one.name : std::to_string(k));
      reading_.termMaterials.push_back({refer(*one.material, *one.where, owner, true, errors), &table, k});
    });
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
      return fmt::format("{}:{}:{}: error: {}", e.where.file, e.where.line, e.where.column,
                         withPaths(e.text));
    return fmt::format("{}: error: {}", name_, withPaths(e.text));
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
