// SPDX-License-Identifier: Apache-2.0
#include "core/scene/buoyancy.hpp"
#include "core/scene/material_use.hpp"
#include "core/terms/buoyant_force.hpp"
#include "core/terms/terms.hpp"

namespace thaw {
namespace {

void readExpansion(KeyTable& keys, Material& m) {
  keys.number("expansion", m.expansion, "1/K", between(-0.1, 0.1),
              "coefficient of volume expansion of the liquid. It causes buoyancy, but does not change "
              "volumes at rest");
  keys.number("expansion_from", m.expansionFrom, "K", notNegative(),
              "temperature at which the liquid has `density`; 0: `domain.ambient`");
}

std::vector<ModuleUse> usesOfBuoyancy(const Scene& s, const Modules& m) {
  if (!m.heat || !hasBuoyancy(s)) return {};
  for (std::size_t k = 0; k < s.materials.size(); k++) {
    const Material& x = s.materials[k];
    if (!inUse(s, k) || !expands(x) || !hasLiquid(m, x)) continue;
    return {{&Modules::buoyancy, "buoyancy",
             "the density of material '" + x.name + "' depends on the temperature; " +
                 (s.numerics.buoyancy == Buoyancy::Boussinesq
                      ? "only differences of density act (`numerics.buoyancy = \"boussinesq\"`)"
                      : "its weight acts, too (`numerics.buoyancy = \"density\"`)")}};
  }
  return {};
}

OutsideSource startBuoyancy(const TermSetup&) {
  return [](const OutsideLoad& load) { addBuoyancy(load.run.scene, load.particles); };
}

void recordBuoyancy(const OutsideLoad& load, HalfKick kick) {
  recordBuoyantKick(load.particles, kick, load.run.scene.domain, load.dt, load.run.ledger);
}

}  // namespace

Extension buoyancyTerm() {
  return {.name = "buoyancy",
          .about = "force on liquids by the difference of their density from that at rest",
          .model = ModelPart{.materialKeys = readExpansion,
                             .uses = usesOfBuoyancy,
                             .stage = LoadStage::Forces,
                             .start = startBuoyancy,
                             .recordKick = recordBuoyancy,
                             .limit = "acceleration",
                             .energies = {"wall_work_J"}}};
}

}  // namespace thaw
