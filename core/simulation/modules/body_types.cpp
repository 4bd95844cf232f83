// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/body_types/redistribute_body_types.hpp"
#include "core/simulation/modules/step_modules.hpp"
#include "core/simulation/step_context.hpp"

namespace thaw {

StepModule bodyTypes() {
  return {"further body types",
          [](const World& w, const TermWork&) { return w.modules.bodyTypes(); },
          {{ModulePhase::Redistributed,
            [](StepContext& c) { redistributeBodyTypes(c.w, c.halos, c.t.redistribution, c.dt); }}}};
}

}  // namespace thaw
