// SPDX-License-Identifier: Apache-2.0
#include "core/rigid/rigidify/rigidify.hpp"
#include "core/rigid/rigidify/deforming.hpp"
#include "core/rigid/rigidify/loads.hpp"
#include "core/simulation/modules/step_modules.hpp"
#include "core/simulation/step_context.hpp"
#include "core/simulation/views/rigidify_views.hpp"

namespace thaw {

/// Parts of elastic solids that move as rigid pieces while they do not deform. Their contacts are forces.
StepModule rigidParts() {
  return {"rigid parts of elastic solids",
          [](const World& w, const TermWork&) { return w.modules.rigidify; },
          {{ModulePhase::AllForces, [](StepContext& c) { compareLoads(rigidifyView(c.w, c.t)); }},
           {ModulePhase::PhaseChange,
            [](StepContext& c) {
              if (findDeforming(rigidifyView(c.w, c.t), c.dt)) c.t.rigid.changedHere = true;
            }},
           {ModulePhase::Limits,
            [](StepContext& c) {
              c.reduction.rigidity = c.t.rigid.changedHere;
              if (!nothingDeforms(rigidifyView(c.w, c.t))) return;
              c.reduction.stretch2 = 0;
              c.reduction.negatedLimits[static_cast<std::size_t>(Limit::Contact)] = -c.limits[Limit::Contact];
            }},
           {ModulePhase::CommonLimits,
            [](StepContext& c) {
              c.t.rigid.changedHere = c.reduction.rigidity > 0;  // on any rank
            }},
           {ModulePhase::EndOfStep, [](StepContext& c) {
              if (!c.finite) return;
              if (c.t.rigid.changedHere) rigidifySolids(rigidifyView(c.w, c.t), c.halos);
              c.t.rigid.changedHere = false;
              c.t.times.lap(StepPhase::Contact);
            }}}};
}

}  // namespace thaw
