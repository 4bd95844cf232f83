// SPDX-License-Identifier: Apache-2.0
// Adaptive sampling (ST92): particles are created in stretched gaps and at open borders, and removed where
// they are too dense.
#pragma once
#include "core/halo/halos.hpp"
#include "core/oriented/data/oriented_view.hpp"

namespace thaw {

/// Returns whether a step of dt (s) ends with adaptive sampling: its number is a multiple of
/// OrientedBody::every. Returns false at the start (dt = 0).
bool adaptSamplingDue(const Scene& scene, const Clock& clock, double dt);

/// Creates and removes particles, with at most one candidate per particle. Returns true if rows changed on
/// any rank; rows must then be redistributed. The rank of a candidate is a hash of id and step. A candidate
/// is accepted if no candidate within a spacing has a lower rank. A body never exceeds OrientedBody::most:
/// only its candidates of lowest rank are accepted. The ledger records births and deaths as entered and left
/// mass with energy 0. dt: s, length of the last step, 0 before the start. Requires: ghosts and neighbour
/// lists. Collective.
bool adaptSampling(const OrientedView& view, Halos halos, double dt);

/// Records the removal of row i in the ledger, and marks the row for the next redistribution.
void removeRow(const OrientedView& view, std::size_t i, double dt);

}  // namespace thaw
