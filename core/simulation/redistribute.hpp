// SPDX-License-Identifier: Apache-2.0
// First part of an evaluation: migration and sorting of particles.
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
/// as long as no row enters or leaves. Results do not depend on this order: sums over all particles are
/// exact, and bonds have their own order.
bool needsOrder(const Modules& modules, const Walls& walls, const SolidWork& solid);

}  // namespace thaw
