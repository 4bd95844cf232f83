// SPDX-License-Identifier: Apache-2.0
#include "core/heat/sources/heat_sources.hpp"
#include "core/simulation/modules/step_modules.hpp"
#include "core/simulation/step_context.hpp"
#include "core/simulation/views/views.hpp"

namespace thaw {

StepModule heatSources() {
  return {"heat sources",
          [](const World& w, const StepTools&) { return w.modules.lamps; },
          {{ModulePhase::AllForces,
            [](StepContext& c) {
              addHeatSources({heatView(c.w), c.w.walls, *c.t.light}, c.dt, c.halos.all);
            }},
           {ModulePhase::Limits, [](StepContext& c) {
              c.reduction.lower(Limit::Heat, sourceStepLimit(c.w.scene, c.w.clock.time));
            }}}};
}

}  // namespace thaw
