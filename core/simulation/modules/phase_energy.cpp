// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "core/contact/solid_contact.hpp"
#include "core/halo/exchange.hpp"
#include "core/simulation/modules/softening.hpp"
#include "core/simulation/modules/step_modules.hpp"
#include "core/simulation/step_context.hpp"
#include "core/simulation/views/body_contact_view.hpp"
#include "core/time/frame_times.hpp"
#include "core/walls/spring_changes.hpp"

namespace thaw {
namespace {

/// Returns the ghost columns that pair energies read and that changed in the step.
ColumnList changedColumns(StepContext& c) {
  Continuum& p = c.w.particles;
  ColumnList changed{&p.liquid, &p.phase};
  if (c.t.terms.pairForces.empty()) return changed;
  changed.push_back(&p.temperature);
  changed.push_back(&p.velocity);
  for (const auto& added : p.added)
    if (added->active && added->ghosts) changed.push_back(added.get());
  return changed;
}

/// Records the energies of contacts and pairs that change with the phase.
void recordChanges(StepContext& c) {
  Continuum& p = c.w.particles;
  // At the end of the scene the next step is unlimited.
  const double planned = nextStep(c.w.clock), next = std::isfinite(planned) ? planned : c.w.clock.stepDt;
  recordSpringChanges(c.walls, c.t.walls.contacts, c.t.phaseChange.energy.springs,
                      {next, next / c.w.clock.substeps});
  if (!(c.reduction.pairsChange > 0)) return;
  refresh(c.halos.cells, p, changedColumns(c)).wait();
  recordStiffnessChanges(c.w.scene, c.t.phaseChange.energy.touching, next, p, c.w.ledger.phaseJump);
  if (c.w.modules.bodyContact)
    recordStiffnessChanges(bodyContactView(c.w, c.t.contact.bodies, c.walls.span, 0), next,
                           c.w.ledger.phaseJump);
  recordPairEnergyChange(c.w, c.t);
}

}  // namespace

StepModule energyOfPhaseChange() {
  return {"energy of phase changes",
          [](const World& w, const TermWork&) { return w.modules.melting; },
          {{ModulePhase::AllForces,
            [](StepContext& c) {
              listSpringStates(c.walls, c.t.walls.contacts, c.t.phaseChange.energy.springs);
            }},
           {ModulePhase::Limits,
            [](StepContext& c) {
              if (changesStiffness(c.t.phaseChange.energy.touching, c.w.particles) ||
                  changesStiffness(c.t.contact.bodies, c.w.particles) ||
                  pairEnergyChanges(c.w, c.t.terms, c.t.phaseChange.energy))
                c.reduction.pairsChange = 1;
            }},
           {ModulePhase::EndOfStep, [](StepContext& c) {
              if (c.finite && c.dt > 0) recordChanges(c);
            }}}};
}

}  // namespace thaw
