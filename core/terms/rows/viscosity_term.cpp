// SPDX-License-Identifier: Apache-2.0
// Viscosity. It is computed by the pressure sum (core/fluid/terms/), or by the implicit solver
// (core/flow/implicit_viscosity/).
#include "core/fluid/flow_laws/flow_law.hpp"
#include "core/materials/liquid_materials.hpp"
#include "core/terms/material_uses.hpp"
#include "core/terms/terms.hpp"

namespace thaw {
namespace {

void readViscosityForm(KeyTable& keys, Numerics& n) {
  keys.restart(Restart::Coefficient);
  keys.choice("viscosity", n.viscosity, {"pairwise", "laplacian"},
              "pairwise: along the line between two particles, which conserves angular momentum. laplacian: "
              "as printed in Keiser et al. 2005");
  keys.byScene().flag(
      "viscosity_correction", n.viscosityCorrection,
      "corrects pairwise viscosity for particle disorder, which changes it by a few per cent while layers "
      "slide past each other. Default: true where viscosity limits explicit steps more than sound does, "
      "except with quality = \"preview\"");
  keys.choice("viscosity_solver", n.viscositySolver, {"explicit", "implicit"},
              "explicit: viscosity limits the step. implicit: a linear system in each step, without this "
              "limit; recommended if viscosity limits the step");
  keys.restart(Restart::Setting);
  keys.number("viscosity_tolerance", n.viscosityTolerance, "", between(1e-10, 0.1),
              "implicit solver: relative error of a step's velocity change by viscosity");
  keys.whole("viscosity_iterations", n.viscosityIterations, 1, 100000,
             "implicit solver: largest number of iterations per step; the summary counts steps that need "
             "more");
  keys.number("cfl_viscous", n.cflViscous, "", stepFactor(),
              "step limit as a multiple of the largest stable dt on a lattice: 0.044 h^2 rho / mu for the "
              "pairwise form with support = 2. Clumped particles need shorter steps");
  if (n.viscositySolver == ViscositySolver::Implicit && n.viscosity == ViscosityForm::Laplacian)
    keys.fail("viscosity_solver",
              "the implicit solver supports the pairwise form of viscosity only: leave "
              "`numerics.viscosity` at \"pairwise\"");
  if (n.viscosityCorrection && n.viscosity == ViscosityForm::Laplacian)
    keys.fail("viscosity_correction",
              "only the pairwise form of viscosity can be corrected: leave `numerics.viscosity` at "
              "\"pairwise\"");
}

void readViscosity(KeyTable& keys, Material& m) {
  keys.byTemperature(
      {"viscosity", "Pa s", notNegative(), LiquidValue::Same,
       "viscosity of the liquid; or a table of pairs `[[\"900 degC\", \"1e4 Pa s\"], [\"1200 degC\", "
       "\"50 Pa s\"]]`, interpolated logarithmically"},
      m.viscosity, m.viscosityTable);
  keys.table("flow",
             "viscosity that depends on the shear rate, instead of `viscosity`: liquids with a yield "
             "stress, shear-thinning and shear-thickening liquids (docs/theory/rheology.md)",
             hasFlowLaw(m), [&](KeyTable& flow) { readFlowLaw(flow, m.flowLaw); });
  keys.byScene().number(
      "bulk_damping", m.bulkDamping, "", between(0, 0.05),
      "damping of sound in liquids with `density = \"continuity\"`. The pressure is taken at the density "
      "extrapolated by the time h / `sound_speed` times this number, with the support radius h. Default: "
      "0.02 where a default of `artificial_viscosity` applies, else 0");
}

void checkViscosity(KeyTable& keys, const Material& m, const Numerics&) {
  if (!keys.has("flow")) return;
  if (keys.has("viscosity"))
    keys.fail("viscosity", "the table `flow` sets the viscosity: remove one of the two");
  if (!canBeLiquid(m))
    keys.fail("flow", "this material is never liquid: remove `flow`, or set `melts` or `phase = \"liquid\"`");
}

std::vector<ModuleUse> heatOfViscosity(const Scene& s) {
  return usesByMaterials(
      s, &Modules::heat, {"the viscosity of ", " depends on the temperature"},
      [](const Material& m) { return !m.viscosityTable.empty() || dependsOnTemperature(m.flowLaw); });
}

std::vector<ModuleUse> usesOfViscosity(const Scene& s, const Modules& m) {
  const Numerics& n = s.numerics;
  std::vector<ModuleUse> uses;
  for (std::size_t k = 0; k < s.materials.size(); k++) {
    const Material& x = s.materials[k];
    if (!inUse(s, k) || !hasLiquid(m, x)) continue;
    const std::string who = "material '" + x.name + "'";
    if (hasFlowLaw(x))
      uses.push_back({&Modules::flowLaw, "the viscosity of " + who + " depends on the shear rate"});
    const bool viscous = x.viscosity.solid > 0 || x.viscosity.liquid > 0 || !x.viscosityTable.empty() ||
                         hasFlowLaw(x);
    if (viscous && n.viscositySolver == ViscositySolver::Implicit)
      uses.push_back({&Modules::implicitViscosity, who});
    if (viscous && n.viscosityCorrection) uses.push_back({&Modules::viscosityCorrection, who});
    if (m.continuity && x.bulkDamping > 0) uses.push_back({&Modules::bulkDamping, who});
  }
  return uses;
}

}  // namespace

Extension viscosityTerm() {
  return {.name = "viscosity",
          .about =
              "friction between layers of a liquid, constant, by temperature or by shear rate; damping "
              "of sound",
          .model = ModelPart{.numericsKeys = readViscosityForm,
                             .materialKeys = readViscosity,
                             .checkMaterial = checkViscosity,
                             .modules = {{&Modules::flowLaw, "flow law"},
                                         {&Modules::implicitViscosity, "implicit viscosity"},
                                         {&Modules::viscosityCorrection, "corrected viscosity"},
                                         {&Modules::bulkDamping, "bulk damping"}},
                             .earlyUses = heatOfViscosity,
                             .uses = usesOfViscosity,
                             .limits = {"viscosity"},
                             .energies = {"dissipated_J"}}};
}

}  // namespace thaw
