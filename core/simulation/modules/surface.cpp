// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/modules/step_modules.hpp"
#include "core/simulation/step_context.hpp"
#include "core/surface/surface_due.hpp"

namespace thaw {

StepModule surfaceMotion() {
  return {"surface",
          [](const World& w, const TermWork&) { return w.modules.surface; },
          {{ModulePhase::Limits, [](StepContext& c) {
              c.reduction.surfaceMove2 = largestSurfaceMove2(c.w.grid, c.w.particles, c.w.surface);
            }}}};
}

}  // namespace thaw
