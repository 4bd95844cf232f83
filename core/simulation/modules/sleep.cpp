// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/modules/step_modules.hpp"
#include "core/simulation/step_context.hpp"
#include "core/simulation/views/views.hpp"

namespace thaw {

StepModule sleepOfSolids() {
  return {"sleep",
          [](const World& w, const TermWork&) { return w.modules.sleep; },
          {{ModulePhase::Migrated,
            [](StepContext& c) {
              const Continuum& p = c.w.particles;
              for (std::size_t i = p.owned - c.t.redistribution.migration.arrivals; i < p.owned; i++)
                c.t.sleep.recomputeAll = c.t.sleep.recomputeAll || p.sleep[i] == sleeping;
            }},
           {ModulePhase::WallContacts, [](StepContext& c) { beginSleep(sleepView(c.w, c.t), c.dt); }},
           {ModulePhase::InnerRows, [](StepContext& c) { markSleepingInner(sleepView(c.w, c.t)); }},
           {ModulePhase::BoundaryRows, [](StepContext& c) { markSleeping(sleepView(c.w, c.t)); }},
           {ModulePhase::Density, [](StepContext& c) { dropSkippedContacts(c.t.sleep, c.t.walls.contacts); }},
           {ModulePhase::Contact,
            [](StepContext& c) { recordConstraintForces(c.w.particles, c.w.scene, c.t.sleep); }},
           {ModulePhase::SecondKick,
            [](StepContext& c) {
              updateSleep(sleepView(c.w, c.t), c.dt);  // solids at rest are fixed from here on
            }}},
          [](Continuum& p) {
            return GhostColumns{{&p.restTime, &p.sleep}, {}};
          }};
}

}  // namespace thaw
