// SPDX-License-Identifier: Apache-2.0
// First part of an evaluation: particles move to their ranks and into order.
#pragma once
#include "core/simulation/step_context.hpp"

namespace thaw {

/// Emits particles and removes those beyond an open side (recorded in the ledger). The others migrate to the
/// rank that owns their cell, and are sorted by (cell, id). Sets StepContext::leftBonds. Collective.
void redistribute(StepContext& context);

/// Returns true if this evaluation needs neighbour lists. A scene of one solid needs them once, to make its
/// bonds.
inline bool needsNeighbours(const Modules& modules, const SolidWork& solid) {
  return modules.neighbours || solid.bondsAtStart;
}

/// Returns true if this evaluation visits cells or rows in (cell, id) order. Otherwise rows keep their order
/// while none comes or goes. No result depends on that: sums over all particles are exact, and bonds have an
/// order of their own.
bool needsOrder(const Modules& modules, const Walls& walls, const SolidWork& solid);

}  // namespace thaw
