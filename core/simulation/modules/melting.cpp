// SPDX-License-Identifier: Apache-2.0
#include "core/heat/heat.hpp"
#include "core/heat/rest_densities.hpp"
#include "core/simulation/modules/softening.hpp"
#include "core/simulation/modules/step_modules.hpp"
#include "core/simulation/step_context.hpp"
#include "core/simulation/views/views.hpp"

namespace thaw {

StepModule melting() {
  return {"melting",
          [](const World& w, const TermWork&) { return w.modules.melting; },
          {{ModulePhase::ContinuumForce,
            [](StepContext& c) {
              // Derivative of compression and tension with respect to the liquid fraction.
              beginSoftening(c.w, c.t);
            }},
           {ModulePhase::PhaseChange, [](StepContext& c) {
              const PhaseChanges changes = changePhase(c.w.scene, c.w.particles, c.w.counters);
              c.t.phaseChange.here = changes.melted || changes.frozen;
              // For this rank; reduceStep combines the flags of all ranks.
              c.t.phaseChange.frozeAnywhere = changes.frozen;
              c.t.phaseChange.meltedAnywhere = changes.melted;
            }}}};
}

StepModule densityByPhase() {
  return {"density by phase",
          [](const World& w, const TermWork&) { return w.modules.phaseDensity; },
          {{ModulePhase::ContinuumForce,
            [](StepContext& c) {
              if (c.w.modules.tension) keepPairEnergy(c.w.particles, c.t.phaseChange.energy);
            }},
           {ModulePhase::PhaseChange, [](StepContext& c) {
              updateRestDensities(heatView(c.w), recordContext(c.w, c.t.liquids),
                                  c.t.phaseChange.energy.ofPairs, c.dt);
            }}}};
}

}  // namespace thaw
