// SPDX-License-Identifier: Apache-2.0
#include "core/terms/material_uses.hpp"
#include "core/terms/terms.hpp"

namespace thaw {
namespace {

void readSmoothing(KeyTable& keys, Material& m) {
  keys.number("xsph", m.xsph, "", between(0, 1), "smoothing of the velocity with which liquid moves (XSPH)");
}

std::vector<ModuleUse> usesOfSmoothing(const Scene& s, const Modules& m) {
  return usesByLiquids(s, m, &Modules::xsph, {}, [](const Material& x) { return x.xsph > 0; });
}

}  // namespace

Extension smoothingTerm() {
  const auto isOn = [](const Numerics&, const Modules& m) { return m.xsph; };
  return {.name = "velocity smoothing",
          .about = "liquid moves with a mean of the velocities around it (XSPH)",
          .model = ModelPart{.materialKeys = readSmoothing,
                             .modules = {{&Modules::xsph, "velocity smoothing (XSPH)"}},
                             .uses = usesOfSmoothing,
                             .sweeps = {{.sum = &PairKernels::smoothing, .isOn = isOn}}}};
}

}  // namespace thaw
