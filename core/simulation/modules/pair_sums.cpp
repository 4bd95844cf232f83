// SPDX-License-Identifier: Apache-2.0
// Sums of forces and heat over neighbours, except those of single modules.
#include "core/simulation/modules/step_modules.hpp"
#include "core/simulation/step_context.hpp"
#include "core/simulation/sums/particle_sums.hpp"

namespace thaw {

StepModule explicitForces() {
  return {"forces that do not depend on the pressure of the step",
          [](const World& w, const TermWork&) { return w.particles.drag.active; },
          {{ModulePhase::ContinuumForce, [](StepContext& c) { addExplicitForces(c.w.particles); }}}};
}

StepModule pairForces() {
  return {"pressure, viscosity and conduction of pairs",
          [](const World& w, const TermWork&) { return w.modules.fluid || w.modules.heat; },
          {{ModulePhase::ForceSums, [](StepContext& c) { sumForces(c.w, c.t, c.rows); }}}};
}

StepModule pairTerms() {
  return {"pair sums of terms",
          [](const World&, const TermWork& terms) { return !terms.sweeps.empty(); },
          {{ModulePhase::ForceSums, [](StepContext& c) { sumTerms(c.w, c.t, c.rows); }}}};
}

}  // namespace thaw
