// SPDX-License-Identifier: Apache-2.0
// Redistribution of oriented particles within an evaluation, after births, deaths and events.
#pragma once
#include "core/halo/halos.hpp"
#include "core/oriented/data/oriented_view.hpp"

namespace thaw {

/// Redistributes oriented particles after births (appended rows with cell 0) and deaths (rows with mass 0).
/// It neither wraps positions nor makes ledger entries. Collective.
void redistributeOriented(OrientedBodies& oriented, const CellGrid& grid, Halos halos, SortBuffers& sort);

/// Redistributes rows and rebuilds ghosts and neighbour lists, after flags, groups or rows have changed.
/// Collective.
void redistributeAndUpdate(const OrientedView& view, Halos halos);

}  // namespace thaw
