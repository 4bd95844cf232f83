// SPDX-License-Identifier: Apache-2.0
// Evaporation (core/heat/evaporation.hpp).
#include "core/materials/liquid_materials.hpp"
#include "core/terms/material_uses.hpp"
#include "core/terms/terms.hpp"

namespace thaw {
namespace {

void readEvaporation(KeyTable& keys, Material& m) {
  keys.byTemperature({"evaporation", "kg/(m^2 s)", notNegative(),
                      "mass that evaporates per time and area of free surfaces of the liquid; or a table of "
                      "pairs by temperature, interpolated linearly; none: no evaporation"},
                     m.evaporation);
  keys.number("evaporation_heat", m.evaporationHeat, "J/kg", notNegative(), "latent heat of evaporation");
}

void checkEvaporation(KeyTable& keys, const Material& m, const Numerics& n) {
  if (n.heat == HeatModel::Paper && keys.has("evaporation"))
    keys.fail("evaporation", "not available with `numerics.heat = \"paper\"`; use \"enthalpy\"");
  if (keys.has("evaporation") && !canBeLiquid(m))
    keys.fail("evaporation",
              "only liquids evaporate, and this material is always solid: remove it, or set `melts`",
              {"young", "phase"});
  if (keys.has("evaporation_heat") && !keys.has("evaporation"))
    keys.fail("evaporation_heat", "has no effect without `evaporation`; set both");
}

bool evaporates(const Material& m) { return !m.evaporation.empty(); }

std::vector<ModuleUse> heatOfEvaporation(const Scene& s) {
  return usesByMaterials(s, &Modules::heat, {"", " evaporates"}, evaporates);
}

std::vector<ModuleUse> usesOfEvaporation(const Scene& s, const Modules& m) {
  return usesByLiquids(s, m, &Modules::evaporation, {"", " loses mass at free surfaces of its liquid"},
                       evaporates);
}

}  // namespace

Extension evaporationTerm() {
  return {.name = "evaporation",
          .about = "mass and heat that free surfaces of liquids lose",
          .heats = true,
          .model = ModelPart{.materialKeys = readEvaporation,
                             .checkMaterial = checkEvaporation,
                             .modules = {{&Modules::evaporation, "evaporation"}},
                             .earlyUses = heatOfEvaporation,
                             .uses = usesOfEvaporation,
                             .energies = {"evaporated_mass_kg", "vapour_heat_J"}}};
}

}  // namespace thaw
