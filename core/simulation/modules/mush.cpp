// SPDX-License-Identifier: Apache-2.0
#include "core/heat/mush.hpp"
#include "core/simulation/modules/step_modules.hpp"
#include "core/simulation/step_context.hpp"
#include "core/simulation/views/views.hpp"

namespace thaw {

StepModule mushDrag() {
  return {
      "mush drag",
      [](const World& w, const TermWork&) { return w.modules.mushDrag; },
      {{ModulePhase::Drift,
        [](StepContext& c) {
          applyMush(heatView(c.w), 0.5 * c.dt, c.dt);
          c.t.redistribution.mayLeave = true;
        }},
       {ModulePhase::AllForces, [](StepContext& c) { findMush(heatView(c.w), c.w.grid, c.w.neighbours); }},
       {ModulePhase::Kicked, [](StepContext& c) { applyMush(heatView(c.w), 0.5 * c.dt, 0); }}}};
}

}  // namespace thaw
