// SPDX-License-Identifier: Apache-2.0
#include "core/sheet/contact/particle_contact.hpp"
#include "core/sheet/step_sheets.hpp"
#include "core/simulation/modules/step_modules.hpp"
#include "core/simulation/step_context.hpp"
#include "core/simulation/views/views.hpp"

namespace thaw {

StepModule sheets() {
  StepModule module{
      "sheets",
      [](const World& w, const TermWork&) { return w.modules.sheet; },
      {{ModulePhase::ObstaclesMoved,
        [](StepContext& c) {
          moveSheets(sheetView(c.w), c.dt);  // exact solution over the step
          c.t.times.lap(StepPhase::SheetMotion);
        }},
       {ModulePhase::Redistributed, [](StepContext& c) { linkSheets(c.w.sheets, c.halos, c.t.times); }},
       {ModulePhase::Coupling,
        [](StepContext& c) {
          // Forces on vertices, and of vertices on particles.
          loadSheets(sheetView(c.w), c.halos, c.t.times, c.dt);
        }},
       {ModulePhase::Kicked,
        [](StepContext& c) {
          c.t.times.lap(StepPhase::Drift);
          kickSheets(sheetView(c.w), c.dt);
          c.t.times.lap(StepPhase::SheetMotion);
        }},
       {ModulePhase::Limits, [](StepContext& c) {
          c.reduction.lower(Limit::Sheet, sheetStepLimit(c.w.sheets, c.w.scene, c.w.clock));
        }}}};
  module.prepare = [](World& w, StepTools& t) { planParticleContact(w.scene, t.liquids, w.sheets.plans); };
  return module;
}

}  // namespace thaw
