// SPDX-License-Identifier: Apache-2.0
#include "core/contact/body_contact.hpp"

#include "core/simulation/modules/step_modules.hpp"
#include "core/simulation/step_context.hpp"
#include "core/simulation/views/body_contact_view.hpp"

namespace thaw {

StepModule bodyContact() {
  return {"contact of bodies",
          [](const World& w, const TermWork&) { return w.modules.bodyContact; },
          {{ModulePhase::WallContacts,  // before new bonds reset the flag
            [](StepContext& c) {
              c.justFrozen = c.t.phaseChange.frozeAnywhere && c.w.modules.freezing && c.dt > 0;
            }},
           {ModulePhase::Density,
            [](StepContext& c) {
              if (c.justFrozen)
                refresh(c.halos.cells, c.w.particles, ColumnList{&c.w.particles.justFrozen}).wait();
              findBodyTouches(bodyContactView(c.w, c.t.contact.bodies, c.walls.span, c.dt),
                              c.justFrozen ? &c.w.ledger.phaseJump : nullptr);
            }},
           {ModulePhase::Contact,
            [](StepContext& c) {
              const BodyContactView view = bodyContactView(c.w, c.t.contact.bodies, c.walls.span, c.dt);
              addBodyContacts(view, c.t.sleep.skipped);
              if (c.w.modules.rareContact) c.contactNear = c.contactNear || touchesSoon(c.t.contact.bodies);
            }},
           {ModulePhase::AllForces,
            [](StepContext& c) { recordResistance(c.walls, c.t.contact.bodies.resistance); }}},
          [](Continuum& p) {
            return GhostColumns{{&p.contactDepth}, {&p.bodyContact}};
          },
          [](World& w, StepTools& t) { prepareBodyContact(w.scene, w.grid, t.contact.bodies); }};
}

}  // namespace thaw
