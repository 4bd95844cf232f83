// SPDX-License-Identifier: Apache-2.0
#include "core/terms/material_uses.hpp"
#include "core/terms/terms.hpp"

namespace thaw {
namespace {

void readArtificialViscosity(KeyTable& keys, Material& m) {
  keys.byScene().number(
      "artificial_viscosity", m.artificialViscosity, "", between(0, 10),
      "Monaghan's alpha for approaching pairs. Default with `density = \"continuity\"` or the incompressible "
      "solver: 0.02, or 0.005 in scenes with a solid material, minus the alpha that is equivalent to the "
      "liquid's viscosity. "
      "`tension = \"curvature\"` adds a viscosity at the free surface. Default "
      "with a form of `tension` other than \"curvature\", with `quality = \"preview\"`, or for one box of "
      "liquid in a periodic domain: 0");
}

std::vector<ModuleUse> usesOfArtificialViscosity(const Scene& s, const Modules& m) {
  return usesByLiquids(s, m, &Modules::artificialViscosity, {},
                       [](const Material& x) { return x.artificialViscosity > 0; });
}

}  // namespace

Extension artificialViscosityTerm() {
  // In scenes of one liquid, the pressure sum includes it (core/fluid/terms/uniform_forces.hpp).
  const auto isOn = [](const Numerics&, const Modules& m) { return m.artificialViscosity && !m.uniform; };
  return {.name = "artificial viscosity",
          .about = "damping of approaching pairs, which keeps sound waves stable",
          .model = ModelPart{.materialKeys = readArtificialViscosity,
                             .modules = {{&Modules::artificialViscosity, "artificial viscosity"}},
                             .uses = usesOfArtificialViscosity,
                             .sweeps = {{.sum = &PairKernels::artificialViscosity,
                                         .isOn = isOn,
                                         .onto = PairTarget::ExplicitForce}},
                             .limits = {"viscosity"},
                             .energies = {"dissipated_J"}}};
}

}  // namespace thaw
