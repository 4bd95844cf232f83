// SPDX-License-Identifier: Apache-2.0
#include "core/materials/liquid_materials.hpp"
#include "core/scene/buoyancy.hpp"
#include "core/scene/material_use.hpp"
#include "core/terms/buoyant_force.hpp"
#include "core/terms/rows/temperature_uses.hpp"
#include "core/terms/terms.hpp"

namespace thaw {
namespace {

void readBuoyancyForm(KeyTable& keys, Numerics& n) {
  keys.restart(Restart::State);
  keys.choice("buoyancy", n.buoyancy, {"automatic", "boussinesq", "density"},
              "buoyancy of liquids with expansion or a table of densities. boussinesq: only density "
              "differences have weight, so noise of the hydrostatic pressure does not hide them. It is for "
              "closed containers full of one liquid: a free surface would be weightless. density: the whole "
              "weight acts. automatic: boussinesq where liquid of one density fills a closed domain, "
              "else density");
}

void readExpansion(KeyTable& keys, Material& m) {
  keys.number("expansion", m.expansion, "1/K", between(-0.1, 0.1),
              "coefficient of volume expansion of the liquid. It causes buoyancy, but does not change "
              "volumes at rest");
  keys.number("expansion_from", m.expansionFrom, "K", notNegative(),
              "temperature at which the liquid has `density`; 0: `domain.ambient`");
}

void checkExpansion(KeyTable& keys, const Material& m, const Numerics&) {
  if (!m.densityTable.empty() && keys.has("expansion"))
    keys.fail("expansion", "the table of densities gives the expansion: remove one of the two", {"density"});
  if (keys.has("expansion_from") && !expands(m))
    keys.fail("expansion_from", "applies only to a liquid with `expansion` or a table of densities",
              {"expansion", "density"});
  if (expands(m) && !canBeLiquid(m))
    keys.fail(keys.has("expansion") ? "expansion" : "density",
              "only liquids have buoyancy, and this material is always solid: give a single density, or set "
              "`melts`",
              {"young", "phase", "melts"});
}

std::vector<ModuleUse> heatOfBuoyancy(const Scene& s) {
  return hasBuoyancy(s) ? usesByTemperatures(s) : std::vector<ModuleUse>{};
}

std::vector<ModuleUse> usesOfBuoyancy(const Scene& s, const Modules& m) {
  if (!m.heat || !hasBuoyancy(s)) return {};
  for (std::size_t k = 0; k < s.materials.size(); k++) {
    const Material& x = s.materials[k];
    if (!inUse(s, k) || !expands(x) || !hasLiquid(m, x)) continue;
    return {{&Modules::buoyancy,
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
          .model = ModelPart{.numericsKeys = readBuoyancyForm,
                             .materialKeys = readExpansion,
                             .checkMaterial = checkExpansion,
                             .modules = {{&Modules::buoyancy, "buoyancy"}},
                             .earlyUses = heatOfBuoyancy,
                             .uses = usesOfBuoyancy,
                             .stage = LoadStage::Forces,
                             .start = startBuoyancy,
                             .recordKick = recordBuoyancy,
                             .limits = {"acceleration"},
                             .energies = {"wall_work_J"}}};
}

}  // namespace thaw
