// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "core/simulation/modules/step_modules.hpp"
#include "core/simulation/step_context.hpp"

namespace thaw {

/// Energy of obstacles that vanish at a given time (Obstacle::until).
StepModule vanishingObstacles() {
  return {"obstacles that vanish",
          [](const World& w, const TermWork&) {
            return std::any_of(w.walls.list.begin(), w.walls.list.end(),
                               [](const Wall& wall) { return wall.properties.until < never; });
          },
          {{ModulePhase::Redistributed,
            [](StepContext& c) {
              if (c.dt > 0 && someVanished(c.w.walls, c.w.clock.time))
                findVanished(c.walls, c.w.clock.time, c.vanished);
            }},
           {ModulePhase::Density, [](StepContext& c) {
              if (!c.vanished.walls.list.empty())
                recordVanished(c.walls, {c.t.surface, c.t.sums.scales.inverseLatticeSum}, c.vanished,
                               c.t.walls.contacts);
            }}}};
}

}  // namespace thaw
