// SPDX-License-Identifier: Apache-2.0
#include "core/heat/heat.hpp"
#include "core/terms/terms.hpp"

namespace thaw {
namespace {

void readAmbient(KeyTable& keys, Domain& d) {
  keys.restart(Restart::Coefficient);
  keys.number("ambient", d.ambient, "K", positive(), "ambient temperature, for convection and radiation");
}

void readExchange(KeyTable& keys, Material& m) {
  keys.number("heat_source", m.heatSource, "W/kg", anyNumber(), "heat produced in the material");
  keys.number("emissivity", m.emissivity, "", between(0, 1),
              "emissivity of free surfaces, for radiation to `domain.ambient`");
  keys.number("convection", m.convection, "W/(m^2 K)", notNegative(),
              "heat transfer coefficient of free surfaces to `domain.ambient`");
}

std::vector<ModuleUse> usesOfHeatExchange(const Scene& s) {
  std::vector<ModuleUse> all;
  for (const Material& m : s.materials) {
    const std::string who = "material '" + m.name + "' ";
    if (m.heatSource != 0) all.push_back({&Modules::heat, who + "has a heat source"});
    if (!(m.convection > 0 || m.emissivity > 0)) continue;
    all.push_back({&Modules::heat, who + "exchanges heat with the ambient"});
    all.push_back({&Modules::surfaceHeat, who + "has convection or emissivity"});
  }
  return all;
}

OutsideSource startHeatExchange(const TermSetup&) {
  return [](const OutsideLoad& load) { addOuterHeat(load.run, load.dt, load.steady); };
}

}  // namespace

Extension heatExchangeTerm() {
  return {.name = "heat exchange",
          .about = "heat produced in materials; convection and radiation of free surfaces",
          .heats = true,
          .model = ModelPart{.domainKeys = readAmbient,
                             .materialKeys = readExchange,
                             .modules = {{&Modules::surfaceHeat, "surface heat"}},
                             .earlyUses = usesOfHeatExchange,
                             .stage = LoadStage::Exchange,
                             .start = startHeatExchange,
                             .energies = {"heat_in_J"}}};
}

}  // namespace thaw
