// SPDX-License-Identifier: Apache-2.0
#include "core/oriented/forces/continuum_contact.hpp"
#include "core/oriented/laws/plan_contact.hpp"
#include "core/oriented/step_oriented.hpp"
#include "core/simulation/modules/step_modules.hpp"
#include "core/simulation/step_context.hpp"
#include "core/simulation/views/views.hpp"

namespace thaw {

StepModule orientedContact() {
  StepModule module{
      "contact of oriented particles and the continuum",
      [](const World& w, const TermWork&) { return w.modules.orientedContact; },
      {{ModulePhase::Coupling, [](StepContext& c) { addContinuumContact(orientedView(c.w, c.t), c.dt); }}}};
  module.prepare = [](World& w, StepTools& t) {
    t.oriented.contacts = planOrientedContact(w.scene, t.liquids);
  };
  return module;
}

StepModule orientedBodies() {
  StepModule module{
      "oriented particles",
      [](const World& w, const TermWork&) { return w.modules.oriented; },
      {{ModulePhase::BeforeMotion,
        [](StepContext& c) {
          // Their own integrator uses obstacles at the positions of the last forces.
          stepOriented(orientedView(c.w, c.t), c.halos, c.dt);
        }},
       {ModulePhase::Redistributed,
        [](StepContext& c) { evaluateOriented(orientedView(c.w, c.t), c.halos, c.dt); }},
       {ModulePhase::Coupling,
        [](StepContext& c) {
          // Contacts of particles born in this step.
          recordBirthContacts(c.w.oriented.rows, c.t.oriented, c.w.ledger);
        }},
       {ModulePhase::Kicked, [](StepContext& c) { c.exceededReach = c.w.oriented.exceededReach; }},
       {ModulePhase::Limits, [](StepContext& c) {
          c.reduction.lower(Limit::Oriented, orientedStepLimit(c.w.oriented.rows, c.w.scene, c.t.oriented));
        }}}};
  module.prepare = [](World& w, StepTools& t) { t.oriented.obstacles = planObstacleContact(w.scene); };
  return module;
}

}  // namespace thaw
