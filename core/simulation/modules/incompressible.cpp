// SPDX-License-Identifier: Apache-2.0
#include "core/flow/incompressible/pressure_solver.hpp"
#include "core/halo/exchange.hpp"
#include "core/simulation/modules/step_modules.hpp"
#include "core/simulation/step_context.hpp"
#include "core/simulation/sums/particle_sums.hpp"
#include "core/time/frame_times.hpp"

namespace thaw {

StepModule incompressiblePressure() {
  return {"incompressible liquid",
          [](const World& w, const TermWork&) { return w.modules.incompressible; },
          {{ModulePhase::FirstKick,
            [](StepContext& c) {
              addPressureImpulse(c.w.particles);  // computed at the end of the last step
            }},
           {ModulePhase::EndOfStep, [](StepContext& c) {
              if (!c.finite) return;
              Continuum& p = c.w.particles;
              if (c.t.phaseChange.meltedAnywhere && p.clamped.active)  // melting releases clamped particles
                refresh(c.halos.cells, p, ColumnList{&p.clamped}).wait();
              // Removes compression from v and computes the next density-pressure impulse.
              solvePressure(c.w, c.halos, c.t, c.dt > 0 ? c.dt : nextStep(c.w.clock));
            }}}};
}

}  // namespace thaw
