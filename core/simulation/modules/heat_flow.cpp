// SPDX-License-Identifier: Apache-2.0
#include "core/heat/contact_heat.hpp"
#include "core/heat/heat.hpp"
#include "core/simulation/modules/step_modules.hpp"
#include "core/simulation/step_context.hpp"
#include "core/simulation/sums/particle_sums.hpp"
#include "core/simulation/views/views.hpp"

namespace thaw {

StepModule heatFlow() {
  return {"heat",
          [](const World& w, const StepTools&) { return w.modules.heat; },
          {{ModulePhase::AllForces, [](StepContext& c) { addWallHeat(c.walls, c.t.wallContacts); }},
           {ModulePhase::PhaseChange, [](StepContext& c) {
              updateHeat(heatView(c.w), c.dt);  // H += heat dt, T and liquid fraction follow
            }}}};
}

StepModule contactConductance() {
  return {"contact conductance",
          [](const World& w, const StepTools&) { return w.modules.contactConductance; },
          {{ModulePhase::Density, [](StepContext& c) {
              findContactNormals(pairSumsOf(c.w, c.t), c.w.particles.owned + c.t.ghostRoom, c.w.particles,
                                 c.t.contactHeat);
            }}}};
}

}  // namespace thaw
