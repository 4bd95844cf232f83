// SPDX-License-Identifier: Apache-2.0
#include <numbers>

#include "core/fluid/pair_sums/records.hpp"
#include "core/materials/liquid_materials.hpp"
#include "core/materials/surface_tension.hpp"
#include "core/scene/material_use.hpp"
#include "core/scene/tension_form.hpp"
#include "core/terms/terms.hpp"

namespace thaw {
namespace {

void readTension(KeyTable& keys, Material& m) {
  keys.byTemperature(
      "surface_tension", m.surfaceTension, m.surfaceTensionTable, "N/m", notNegative(),
      "surface tension of the liquid; or a table by temperature, `[[\"20 degC\", \"72.7 mN/m\"], "
      "[\"80 degC\", \"62.7 mN/m\"]]`, interpolated linearly");
  keys.defaultAs("\"90 deg\"")
      .number("contact_angle", m.contactAngle, "rad", between(0, std::numbers::pi),
              "angle between the liquid's surface and a wall, measured in the liquid: \"30 deg\" wets, \"150 "
              "deg\" beads. It applies at sides of the domain and at obstacles without their own angle. "
              "Solid bodies always have 90 degrees");
  if (keys.reading() && !m.surfaceTensionTable.empty())
    m.surfaceTension = largestTension(m.surfaceTensionTable);
}

std::vector<ModuleUse> usesOfTension(const Scene& s, const Modules& m) {
  const bool energy = s.numerics.tension == TensionForm::SurfaceEnergy;
  std::vector<ModuleUse> uses;
  for (std::size_t k = 0; k < s.materials.size(); k++) {
    const Material& x = s.materials[k];
    if (!inUse(s, k) || !hasLiquid(m, x) || !(x.surfaceTension > 0)) continue;
    const std::string who = "material '" + x.name + "'";
    uses.push_back({&Modules::tension, "surface tension", who});
    if (s.numerics.tension == TensionForm::Curvature)
      uses.push_back({&Modules::artificialViscosity, "artificial viscosity", "the free surface of " + who});
    if (!energy) continue;
    uses.push_back({&Modules::surfaceEnergy, "surface tension as an energy", "numerics.tension"});
    if (!x.surfaceTensionTable.empty())
      uses.push_back({&Modules::tensionTable, "tension by temperature",
                      "the surface tension of " + who + " is a table"});
    for (const std::string& where : contactAnglesOf(s, x))
      uses.push_back({&Modules::contactAngle, "contact angles", where});
  }
  return uses;
}

}  // namespace

Extension tensionTerm() {
  const auto isEnergy = [](const Numerics&, const Modules& m) { return m.surfaceEnergy; };
  const auto isPairwise = [](const Numerics& n, const Modules& m) {
    return m.tension && !m.surfaceEnergy && !actsByCurvature(n, m);
  };
  return {
      .name = "surface tension",
      .about = "tension of free surfaces of liquids, by the form that `numerics.tension` chooses",
      .model = ModelPart{
          .materialKeys = readTension,
          .uses = usesOfTension,
          .sweeps = {{.sum = &PairKernels::surfaceForces,
                      .isOn = isEnergy,
                      .onto = PairTarget::PositionForce,
                      .pack = packSurfaceEnergyDerivatives},
                     {.sum = &PairKernels::tension, .isOn = isPairwise, .onto = PairTarget::PositionForce}},
          .limit = "surface tension",
          .energies = {"surface_tension_J"}}};
}

}  // namespace thaw
