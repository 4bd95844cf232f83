// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "core/scene/modules.hpp"
#include "core/terms/extensions.hpp"
#include "io/scene/tables/read_sections.hpp"

namespace thaw {

namespace {

void checkRigidify(const SceneReading& x, std::vector<SceneError>& errors) {
  const Scene& s = *x.scene;
  const Numerics& n = s.numerics;
  if (!(n.rigidify > 0)) return;
  const auto at = x.numerics.find("rigidify");
  const SourcePlace where = at != x.numerics.end() ? at->second : x.start;
  const auto refuse = [&](bool is, const std::string& what) {
    if (is)
      errors.push_back(
          {where, "`numerics.rigidify` cannot be combined with " + what + ": leave one of them out"});
  };
  refuse(n.sleepSpeed > 0, "`numerics.sleep_speed`");
  refuse(n.elasticSubsteps > 1, "`numerics.elastic_substeps` above 1");
  for (const Material& m : s.materials) {
    if (!m.canBeSolid()) continue;
    const auto property = [&](bool is, const char* what) {
      refuse(is, fmt::format("{} of material '{}'", what, m.name));
    };
    property(m.isRigid(), "`law = \"rigid\"`");
    property(!findExtension(m.law.name)->builtIn, "the extension law");
    property(m.yieldStrain.solid < never || m.yieldStrain.liquid < never, "`yield_strain`");
    property(m.breakStretch < never, "`break_stretch`");
  }
}

}  // namespace

void checkRigid(const SceneReading& x, std::vector<SceneError>& errors) {
  const Scene& s = *x.scene;
  const Numerics& n = s.numerics;
  checkRigidify(x, errors);
  const auto rigid = std::find_if(s.materials.begin(), s.materials.end(),
                                  [](const Material& m) { return m.isRigid(); });
  if (rigid == s.materials.end()) return;
  const auto refuse = [&](bool is, const char* what) {
    if (is)
      errors.push_back(
          {rigid->where, fmt::format("material.{}: `law = \"rigid\"` cannot be combined with {}: "
                                     "choose another law, or leave it out",
                                     rigid->name, what)});
  };
  refuse(n.viscosity == ViscosityForm::Laplacian, "`numerics.viscosity = \"laplacian\"`");
  const bool elastic = std::any_of(s.materials.begin(), s.materials.end(), [](const Material& m) {
    return m.canBeSolid() && !m.isRigid() && !m.liquidAtStart;
  });
  refuse(n.sleepSpeed > 0 && elastic, "`numerics.sleep_speed` in a scene that also has elastic solids");
  for (const Emitter& e : s.emitters) {
    if (e.material < 0) continue;  // reported already
    const Material& m = s.materials[static_cast<std::size_t>(e.material)];
    if (m.isRigid() && (solidAt(m, e.temperature) || (e.temperatureField && m.melts())))
      errors.push_back({e.where, fmt::format("emitter '{}' emits the rigid material '{}' as a solid: emit it "
                                             "as a liquid, or choose another law",
                                             e.name, m.name)});
  }
}

}  // namespace thaw
