// SPDX-License-Identifier: Apache-2.0
#include "core/domain/outside_forces.hpp"
#include "core/simulation/modules/step_modules.hpp"
#include "core/simulation/step_context.hpp"
#include "core/simulation/sums/particle_sums.hpp"

namespace thaw {

/// Always on: a program may add loads during a run (Simulation::addForce), and a checkpoint may have some.
StepModule outsideLoads() {
  return {"loads from outside",
          [](const World&, const StepTools&) { return true; },
          {{ModulePhase::FirstKick,
            [](StepContext& c) {
              Continuum& p = c.w.particles;
              if (p.outsideForce.active)
                recordOutsideKick(p, HalfKick::First, c.w.scene.domain.gravity, c.dt, c.w.ledger);
            }},
           {ModulePhase::AllForces,
            [](StepContext& c) {
              Continuum& p = c.w.particles;
              if (p.outsideForce.active) addOutsideLoads(c.t.outside, p, c.w.ledger, c.time, c.dt);
            }},
           {ModulePhase::SecondKick, [](StepContext& c) {
              Continuum& p = c.w.particles;
              if (p.outsideForce.active)
                recordOutsideKick(p, HalfKick::Second, c.w.scene.domain.gravity, c.dt, c.w.ledger);
            }}}};
}

StepModule extensionPairForces() {
  return {"pair forces of extensions",
          [](const World&, const StepTools& t) { return !t.pairForces.empty(); },
          {{ModulePhase::ContinuumForce, [](StepContext& c) { sumPairForces(c.w, c.t); }}}};
}

}  // namespace thaw
