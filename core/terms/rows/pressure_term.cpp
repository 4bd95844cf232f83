// SPDX-License-Identifier: Apache-2.0
// Density and pressure of liquids. Their sums are in core/fluid/terms/, the forms of the density in
// core/flow/density/, the solver in core/flow/incompressible/.
#include "core/terms/terms.hpp"

namespace thaw {
namespace {

void readPressureForms(KeyTable& keys, Numerics& n) {
  keys.restart(Restart::Coefficient);
  keys.choice("pressure", n.pressure, {"consistent", "printed"},
              "consistent: pair form that conserves energy. printed: as printed in Keiser et al. 2005, which "
              "gives half the gradient");
  keys.byScene().choice(
      "density", n.density, {"summation", "continuity", "plain"},
      "density of liquids. summation: a sum over positions, consistent with compression. "
      "continuity: integrated from the divergence of the flow. plain: the plain sum. Default: "
      "\"continuity\"; \"summation\" with a form of `tension` other than \"curvature\", `quality = "
      "\"preview\"`, `pressure = \"printed\"` or the incompressible solver");
  keys.flag(
      "corrected_gradients", n.correctedGradients,
      "gradients of the continuity form and of the incompressible solver are exact for linear fields inside "
      "the liquid (Bonet & Lok 1999)");
  keys.number("density_diffusion", n.densityDiffusion, "", between(0, 1),
              "density diffusion of the continuity form");
  keys.byScene().number(
      "shifting", n.shifting, "", between(0, 0.3),
      "largest speed of shifting: particles of a liquid move down the gradient of their concentration C. It "
      "is a multiple of the speed of sound times h grad C. With the continuity form it scales with strain "
      "and tension, and particles at the free surface are not shifted. 0: no shifting. Default with density "
      "= \"continuity\": 0.07 with gravity, 0.2 without");
  keys.choice("equation_of_state", n.eos, {"linear", "tait"}, "pressure as a function of the density");
  keys.byScene().number("tensile_limit", n.tensileLimit, "", between(0, 1),
                        "fraction of negative pressure that is kept. Above 0 it requires `density = "
                        "\"continuity\"` and shifting "
                        "above 0. Default: 1 with both, except with a form of `tension` other than "
                        "\"curvature\", or `quality = \"preview\"`");
  keys.choice("pressure_solver", n.solver, {"state equation", "incompressible"},
              "state equation: pressure from the density. incompressible: solved for, so that liquids keep "
              "their volume; the speed of the flow limits the step, not that of sound");
  keys.restart(Restart::Setting);
  keys.number("density_tolerance", n.densityTolerance, "", {0, 0.1, true, false, false},
              "incompressible: the solver stops when the mean remaining compression of a step is below this. "
              "Earlier compression is removed in the time in which the flow moves by one spacing");
  keys.number("divergence_tolerance", n.divergenceTolerance, "", {0, 0.1, true, false, false},
              "incompressible: mean rate of compression, times the step, below which the solver stops");
  keys.whole(
      "max_iterations", n.maxIterations, 1, 100000,
      "incompressible: largest number of iterations per solve; the summary counts solves that reach it");
  keys.restart(Restart::Coefficient);
  keys.number("max_density_error", n.maxDensityError, "", {0, 0.2, true, false, false},
              "compression that the automatic sound speed allows");
  keys.restart(Restart::Setting);
  keys.number("cfl_sound", n.cflSound, "", stepFactor(),
              "step limit as a multiple of h / c, with the support radius h");
}

void readSoundSpeed(KeyTable& keys, Material& m) {
  keys.number(
      "sound_speed", m.soundSpeed, "m/s", notNegative(),
      "speed of sound of the equation of state; 0: from the largest expected speed and `max_density_error`");
}

std::vector<ModuleUse> usesOfPressure(const Scene& s, const Modules& m) {
  const Numerics& n = s.numerics;
  std::vector<ModuleUse> uses;
  if (!m.fluid) return uses;
  if (n.density == DensityForm::Continuity) {
    uses.push_back({&Modules::continuity, "liquid with `numerics.density = \"continuity\"`"});
    if (n.correctedGradients) uses.push_back({&Modules::corrected, "numerics.corrected_gradients"});
  }
  if (n.shifting > 0) uses.push_back({&Modules::shifting, "numerics.shifting"});
  if (n.solver == PressureSolver::Incompressible)
    uses.push_back({&Modules::incompressible, "numerics.pressure_solver"});
  return uses;
}

}  // namespace

Extension pressureTerm() {
  return {.name = "pressure",
          .about =
              "density and pressure of liquids, by the forms that `numerics` chooses; shifting of their "
              "particles",
          .model = ModelPart{.numericsKeys = readPressureForms,
                             .materialKeys = readSoundSpeed,
                             .modules = {{&Modules::continuity, "density by continuity"},
                                         {&Modules::corrected, "corrected gradients"},
                                         {&Modules::shifting, "shifting of particles"},
                                         {&Modules::incompressible, "incompressible liquid"}},
                             .uses = usesOfPressure,
                             .limits = {"sound", "density change"},
                             .energies = {"compression_J", "dissipated_J"}}};
}

}  // namespace thaw
