// SPDX-License-Identifier: Apache-2.0
// Conduction of heat and contact conductance (core/heat/contact_heat.hpp). The sum of conduction is part of
// the pressure sum (core/fluid/terms/forces.hpp), or core/fluid/terms/conduction.hpp without pressure.
#include "core/terms/material_uses.hpp"
#include "core/terms/rows/temperature_uses.hpp"
#include "core/terms/terms.hpp"

namespace thaw {
namespace {

void readHeatModel(KeyTable& keys, Numerics& n) {
  keys.restart(Restart::Coefficient);
  keys.as(Restart::State)
      .choice("heat", n.heat, {"enthalpy", "paper"},
              "enthalpy: with latent heat. paper: the plain temperature of Keiser et al. 2005");
  keys.choice("conduction", n.conduction, {"normalised", "plain"},
              "sum for heat conduction. normalised: exact for a quadratic temperature on the lattice. plain: "
              "with the kernel's own constant");
  keys.restart(Restart::Setting);
  keys.number("cfl_heat", n.cflHeat, "", stepFactor(),
              "step limit as a multiple of the largest stable dt on a lattice: 0.078 h^2 / diffusivity for "
              "the wendland kernel with support = 2");
}

void readConduction(KeyTable& keys, Material& m) {
  keys.blend({"conductivity", "W/(m K)", notNegative(), LiquidValue::Same,
              "heat conductivity; 0: no heat is conducted"},
             m.conductivity);
  keys.number("contact_conductance", m.contactConductance, "W/(m^2 K)", orNever(positive()),
              "heat conductance of its contacts with other bodies, if at most one is liquid. The smaller "
              "value of the two materials applies. \"never\": no resistance");
  keys.number("paper_diffusivity", m.paperDiffusivity, "m^2/s", notNegative(),
              "k_heat of Keiser et al. 2005, with `numerics.heat = \"paper\"`");
}

void checkConductance(KeyTable& keys, const Material& m, const Numerics& n) {
  if (n.heat == HeatModel::Paper && keys.has("contact_conductance"))
    keys.fail("contact_conductance", "not available with `numerics.heat = \"paper\"`; use \"enthalpy\"");
  if (keys.has("contact_conductance") && !(m.conductivity.solid > 0 || m.conductivity.liquid > 0))
    keys.fail("contact_conductance", "has no effect without `conductivity`; set both");
}

bool conducts(const Material& m) {
  return m.conductivity.solid > 0 || m.conductivity.liquid > 0 || m.paperDiffusivity > 0;
}

std::vector<ModuleUse> heatOfConduction(const Scene& s) {
  if (!std::any_of(s.materials.begin(), s.materials.end(), conducts)) return {};
  std::vector<ModuleUse> uses = usesByTemperatures(s);
  for (const Obstacle& o : s.obstacles)
    if (o.temperature) uses.push_back({&Modules::heat, "obstacle '" + o.name + "' has a temperature"});
  return uses;
}

std::vector<ModuleUse> usesOfConductance(const Scene& s, const Modules& m) {
  if (!m.heat || s.bodies.size() + s.emitters.size() < 2) return {};
  return usesByMaterials(s, &Modules::contactConductance,
                         {"heat from ", " to other bodies meets a resistance"},
                         [&](const Material& x) { return inUse(s, x) && x.contactConductance < never; });
}

}  // namespace

Extension conductionTerm() {
  return {.name = "heat conduction",
          .about = "heat that flows between particles, bodies and obstacles of different temperatures",
          .heats = true,
          .model = ModelPart{
              .numericsKeys = readHeatModel,
              .materialKeys = readConduction,
              .checkMaterial = checkConductance,
              .modules = {{&Modules::heat, "heat"}, {&Modules::contactConductance, "contact conductance"}},
              .earlyUses = heatOfConduction,
              .uses = usesOfConductance,
              .limits = {"heat"},
              .energies = {"internal_J", "heat_in_J"}}};
}

}  // namespace thaw
