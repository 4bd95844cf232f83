// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/modules/step_modules.hpp"
#include "core/simulation/step_context.hpp"
#include "core/simulation/sums/particle_sums.hpp"

namespace thaw {

StepModule implicitViscosity() {
  return {"implicit viscosity",
          [](const World& w, const TermWork&) { return w.modules.implicitViscosity; },
          {{ModulePhase::AllForces, [](StepContext& c) { solveViscosity(c.w, c.halos, c.t, c.walls); }}}};
}

StepModule viscosityCorrection() {
  return {"corrected viscosity",
          [](const World& w, const TermWork&) { return w.modules.viscosityCorrection; },
          {{ModulePhase::AllForces, [](StepContext& c) {
              // For the next step.
              if (viscosityCorrectionDue(c.w.modules, c.w.clock)) correctViscosity(c.w, c.t.sums, c.t.walls);
            }}}};
}

}  // namespace thaw
