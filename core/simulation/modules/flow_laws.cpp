// SPDX-License-Identifier: Apache-2.0
#include "core/flow/rheology/apparent_viscosity.hpp"
#include "core/simulation/modules/step_modules.hpp"
#include "core/simulation/step_context.hpp"
#include "core/simulation/sums/particle_sums.hpp"

namespace thaw {

StepModule flowLaws() {
  return {"flow law",
          [](const World& w, const TermWork&) { return w.modules.flowLaw; },
          {{ModulePhase::Density,
            [](StepContext& c) {
              findApparentViscosity(c.walls, c.t.walls.contacts, pairSumsOf(c.w, c.t.sums));
            }}},
          [](Continuum& p) {
            return GhostColumns{{}, {&p.apparentViscosity}};
          }};
}

}  // namespace thaw
