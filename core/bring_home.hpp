// The first part of an evaluation: who is there, on which rank, in which order.
#pragma once
#include "core/step.hpp"

namespace thaw {

/// Emits particles, lets those beyond an open side go (booked in the ledger), sends the others to the rank
/// that owns their cell and sorts by (cell, id). Returns whether a particle with bonds left the domain.
bool bringHome(World& world, Halos halos, StepTools& tools, double dt);

/// Does this evaluation need neighbour lists? A scene of one solid needs them once, to make its bonds.
inline bool needsNeighbours(const World& world, const StepTools& tools) {
  return world.modules.neighbours || tools.bondsAtStart;
}

/// Does this evaluation go through cells, or through what is in them in the order of (cell, id)? Where nobody
/// does rows stay as they are while none comes or goes, and no bit of a result depends on it: sums over all
/// particles are exact, and bonds have an order of their own.
bool needsOrder(const World& world, const StepTools& tools);

}  // namespace thaw
