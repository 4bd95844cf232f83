// SPDX-License-Identifier: Apache-2.0
#include "io/run/reports/solver_use.hpp"

#include <algorithm>

namespace thaw {

std::vector<SolverUse> solversOf(const World& w, const StepTools& t) {
  const double steps = static_cast<double>(std::max<std::int64_t>(1, w.clock.step));
  const auto mean = [&](std::int64_t all) { return static_cast<double>(all) / steps; };
  const Counters& c = w.counters;
  std::vector<SolverUse> used;
  if (w.modules.incompressible) {
    used.push_back({"density", w.pressureIterations.density, mean(c.densityIterations)});
    used.push_back({"divergence", w.pressureIterations.divergence, mean(c.divergenceIterations)});
  }
  if (w.modules.implicitViscosity)
    used.push_back({"viscosity", t.viscous.iterations, mean(c.viscousIterations)});
  if (w.modules.rigid && !w.modules.rigidify)
    used.push_back({"contact", t.rigid.contacts.iterations, mean(c.contactIterations),
                    t.rigid.contacts.residual, t.rigid.contacts.tolerance, t.rigid.contacts.deepest});
  return used;
}

}  // namespace thaw
