// SPDX-License-Identifier: Apache-2.0
#include "core/domain/terms.hpp"
#include "core/materials/liquid_materials.hpp"
#include "core/scene/material_use.hpp"

namespace thaw {
namespace {

void readSmoothing(KeyTable& keys, Material& m) {
  keys.number("xsph", m.xsph, "", between(0, 1), "smoothing of the velocity with which liquid moves (XSPH)");
}

std::vector<ModuleUse> usesOfSmoothing(const Scene& s, const Modules& m) {
  std::vector<ModuleUse> uses;
  for (std::size_t k = 0; k < s.materials.size(); k++)
    if (const Material& x = s.materials[k]; inUse(s, k) && hasLiquid(m, x) && x.xsph > 0)
      uses.push_back({&Modules::xsph, "velocity smoothing (XSPH)", "material '" + x.name + "'"});
  return uses;
}

}  // namespace

Extension smoothingTerm() {
  const auto isOn = [](const Numerics&, const Modules& m) { return m.xsph; };
  return {.name = "velocity smoothing",
          .about = "liquid moves with a mean of the velocities around it (XSPH)",
          .model = ModelPart{.materialKeys = readSmoothing,
                             .uses = usesOfSmoothing,
                             .sweeps = {{.sum = &PairKernels::smoothing, .isOn = isOn}}}};
}

}  // namespace thaw
