// SPDX-License-Identifier: Apache-2.0
#include "core/heat/contact_heat.hpp"
#include "core/heat/cover_areas.hpp"
#include "core/heat/heat.hpp"
#include "core/simulation/modules/step_modules.hpp"
#include "core/simulation/step_context.hpp"
#include "core/simulation/sums/particle_sums.hpp"
#include "core/simulation/views/views.hpp"

namespace thaw {

StepModule heatFlow() {
  return {"heat",
          [](const World& w, const TermWork&) { return w.modules.heat; },
          {{ModulePhase::AllForces, [](StepContext& c) { addWallHeat(c.walls, c.t.walls.contacts); }},
           {ModulePhase::PhaseChange, [](StepContext& c) {
              updateHeat(heatView(c.w), c.dt);  // H += heat dt, T and liquid fraction follow
            }}}};
}

StepModule exposedAreas() {
  return {"areas exposed to the ambient",
          [](const World& w, const TermWork&) { return w.modules.surfaceHeat; },
          {{ModulePhase::ForceSums,
            [](StepContext& c) {
              findExposedAreas(pairSumsOf(c.w, c.t.sums), c.w.scene.numerics,
                               c.w.particles.exposedArea.data(), c.rows.groups);
            }},
           {ModulePhase::AllForces, [](StepContext& c) { coverAreas(c.walls.world, c.t.walls.contacts); }}}};
}

StepModule conductionCorrection() {
  constexpr std::int64_t everySteps = 8;  // surfaces move by much less than a spacing in this time
  return {"corrected conduction",
          [](const World& w, const TermWork&) { return w.particles.conductionCorrection.active; },
          {{ModulePhase::AllForces,
            [](StepContext& c) {
              if (c.dt != 0 && (c.w.clock.step + 1) % everySteps != 0) return;
              // used in the next step
              correctConduction(pairSumsOf(c.w, c.t.sums), c.walls, c.t.walls.contacts, c.t.heat.conduction);
            }}},
          [](Continuum& p) {
            return GhostColumns{{&p.conductionCorrection}, {}};
          }};
}

StepModule contactConductance() {
  return {"contact conductance",
          [](const World& w, const TermWork&) { return w.modules.contactConductance; },
          {{ModulePhase::Density,
            [](StepContext& c) {
              findContactNormals(pairSumsOf(c.w, c.t.sums), c.w.particles.owned + c.t.sums.ghostRoom,
                                 c.w.particles, c.t.heat.contact);
            }},
           {ModulePhase::ForceSums,
            [](StepContext& c) {  // runs after the conduction, which it corrects
              packContactFaces(c.w.scene, c.w.particles, c.rows.begin, c.rows.end, c.t.heat.contact);
              addContactHeat(pairSumsOf(c.w, c.t.sums), c.t.heat.contact, c.rows.groups);
            }}},
          [](Continuum& p) {
            return GhostColumns{{&p.body}, {&p.contactNormal}};
          }};
}

}  // namespace thaw
