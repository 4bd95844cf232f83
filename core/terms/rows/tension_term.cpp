// SPDX-License-Identifier: Apache-2.0
#include <numbers>

#include "core/fluid/pair_sums/records.hpp"
#include "core/materials/liquid_materials.hpp"
#include "core/materials/surface_tension.hpp"
#include "core/scene/material_use.hpp"
#include "core/scene/tension_form.hpp"
#include "core/terms/material_uses.hpp"
#include "core/terms/terms.hpp"

namespace thaw {
namespace {

void readTensionForm(KeyTable& keys, Numerics& n) {
  keys.restart(Restart::Coefficient);
  keys.byScene().choice(
      "tension", n.tension, {"pairwise", "colour field", "surface energy", "curvature"},
      "pairwise: cohesion of pairs, cheap, but drops behave like soft crystals. colour field: as printed in "
      "Keiser et al. 2005. surface energy: drops have Laplace's pressure and oscillate like liquids. Energy "
      "and momentum are conserved, but surfaces at rest resist flow. curvature: a force by the curvature of "
      "the free surface, for contact angles and flow along surfaces. It needs `density = \"continuity\"` "
      "and shifting. Default: \"curvature\"; \"surface energy\" without these two, with a support below "
      "1.9, `quality = \"preview\"`, `pressure = \"printed\"` or the incompressible solver");
  keys.restart(Restart::Setting);
  keys.number("cfl_tension", n.cflTension, "", stepFactor(),
              "step limit as a multiple of sqrt(rho h^3 / (2 pi sigma))");
}

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

void checkTension(KeyTable& keys, const Material& m, const Numerics&) {
  if (keys.has("contact_angle") && !(m.surfaceTension > 0))
    keys.fail("contact_angle", "has no effect without `surface_tension`; set both", {"surface_tension"});
  if (!m.surfaceTensionTable.empty() && !canBeLiquid(m))
    keys.fail("surface_tension",
              "only liquids have surface tension, and this material is always solid: remove it, or set "
              "`melts`",
              {"young", "phase", "melts"});
}

std::vector<ModuleUse> heatOfTension(const Scene& s) {
  return usesByMaterials(s, &Modules::heat, {"the surface tension of ", " depends on the temperature"},
                         [](const Material& m) { return !m.surfaceTensionTable.empty(); });
}

std::vector<ModuleUse> usesOfTension(const Scene& s, const Modules& m) {
  const bool energy = s.numerics.tension == TensionForm::SurfaceEnergy;
  std::vector<ModuleUse> uses;
  for (std::size_t k = 0; k < s.materials.size(); k++) {
    const Material& x = s.materials[k];
    if (!inUse(s, k) || !hasLiquid(m, x) || !(x.surfaceTension > 0)) continue;
    const std::string who = "material '" + x.name + "'";
    uses.push_back({&Modules::tension, who});
    if (s.numerics.tension == TensionForm::Curvature)
      uses.push_back({&Modules::artificialViscosity, "the free surface of " + who});
    if (!energy) continue;
    uses.push_back({&Modules::surfaceEnergy, "numerics.tension"});
    if (!x.surfaceTensionTable.empty())
      uses.push_back({&Modules::tensionTable, "the surface tension of " + who + " is a table"});
    for (const std::string& where : contactAnglesOf(s, x)) uses.push_back({&Modules::contactAngle, where});
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
          .numericsKeys = readTensionForm,
          .materialKeys = readTension,
          .checkMaterial = checkTension,
          .modules = {{&Modules::tension, "surface tension"},
                      {&Modules::surfaceEnergy, "surface tension as an energy"},
                      {&Modules::tensionTable, "tension by temperature"},
                      {&Modules::contactAngle, "contact angles"}},
          .earlyUses = heatOfTension,
          .uses = usesOfTension,
          .sweeps = {{.sum = &PairKernels::surfaceForces,
                      .isOn = isEnergy,
                      .onto = PairTarget::PositionForce,
                      .pack = packSurfaceEnergyDerivatives},
                     {.sum = &PairKernels::tension, .isOn = isPairwise, .onto = PairTarget::PositionForce}},
          .limits = {"surface tension"},
          .energies = {"surface_tension_J"}}};
}

}  // namespace thaw
