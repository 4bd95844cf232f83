// SPDX-License-Identifier: Apache-2.0
#include "core/domain/buoyant_force.hpp"
#include "core/simulation/modules/step_modules.hpp"
#include "core/simulation/step_context.hpp"

namespace thaw {

StepModule buoyancy() {
  return {"buoyancy",
          [](const World& w, const StepTools&) { return w.modules.buoyancy; },
          {{ModulePhase::FirstKick,
            [](StepContext& c) {
              recordBuoyantKick(c.w.particles, HalfKick::First, c.w.scene.domain, c.dt, c.w.ledger);
            }},
           {ModulePhase::ContinuumForce, [](StepContext& c) { addBuoyancy(c.w.scene, c.w.particles); }},
           {ModulePhase::SecondKick, [](StepContext& c) {
              recordBuoyantKick(c.w.particles, HalfKick::Second, c.w.scene.domain, c.dt, c.w.ledger);
            }}}};
}

}  // namespace thaw
