// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/modules/step_modules.hpp"
#include "core/simulation/step_context.hpp"
#include "core/simulation/sums/particle_sums.hpp"
#include "core/simulation/sums/softening.hpp"
#include "core/simulation/views/views.hpp"

namespace thaw {

StepModule evaporation() {
  return {"evaporation",
          [](const World& w, const TermWork&) { return w.modules.evaporation; },
          {{ModulePhase::Density,
            [](StepContext& c) {
              c.t.sums.kernels->freeSurfaceIndicator(pairSumsOf(c.w, c.t.sums), {0, c.w.neighbours.groups});
              findExposure(evaporationView(c.w, c.t));
            }},
           {ModulePhase::ContinuumForce,
            [](StepContext& c) { keepPairEnergy(c.w.particles, c.t.phaseChange.energy); }},
           {ModulePhase::AllForces, [](StepContext& c) {
              findVapour(evaporationView(c.w, c.t), c.walls, c.t.phaseChange.energy.ofPairs, c.dt);
            }}}};
}

}  // namespace thaw
