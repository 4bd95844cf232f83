// SPDX-License-Identifier: Apache-2.0
#include "core/contact/solid_contact.hpp"
#include "core/simulation/modules/step_modules.hpp"
#include "core/simulation/step_context.hpp"
#include "core/simulation/sums/particle_sums.hpp"

namespace thaw {

StepModule solidContact() {
  return {
      "contact of solids",
      [](const World& w, const TermWork&) { return w.modules.contact; },
      {{ModulePhase::ForceSums,
        [](StepContext& c) {
          if (c.rows.part == Part::Inner) c.t.contact.closePairs.list.clear();
          c.t.sums.kernels->closePairs(pairSumsOf(c.w, c.t.sums), c.rows.groups, c.t.contact.closePairs);
        }},
       {ModulePhase::Contact,
        [](StepContext& c) {
          World& w = c.w;
          addSolidContacts({w.scene, w.grid, w.solids, w.bonds, c.walls.span,
                            w.modules.melting ? &c.t.phaseChange.energy.touching : nullptr,
                            &c.t.contact.resistance, w.modules.fluid ? nullptr : &w.counters.coincidentPairs,
                            w.modules.rareContact ? &c.contactNear : nullptr},
                           c.t.contact.closePairs, w.particles);
        }},
       {ModulePhase::Limits,
        [](StepContext& c) {
          // Particles that freeze may have contact forces from the next evaluation on.
          if (c.contactNear || (c.w.modules.rareContact && c.t.phaseChange.frozeAnywhere))
            c.reduction.lower(Limit::Contact, c.t.limits.longestContact);
        }},
       {ModulePhase::AllForces, [](StepContext& c) { recordResistance(c.walls, c.t.contact.resistance); }}}};
}

}  // namespace thaw
