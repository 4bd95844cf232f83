// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/modules/step_modules.hpp"
#include "core/simulation/step_context.hpp"
#include "core/simulation/sums/particle_sums.hpp"

namespace thaw {

StepModule extensionPairForces() {
  return {"pair forces of extensions",
          [](const World&, const TermWork& terms) { return !terms.pairForces.empty(); },
          {{ModulePhase::ContinuumForce, [](StepContext& c) { sumPairForces(c.w, c.t); }}}};
}

}  // namespace thaw
