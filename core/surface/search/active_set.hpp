// SPDX-License-Identifier: Apache-2.0
// Active set of surfels for later rounds of resampling.
#pragma once
#include <vector>

#include "core/halo/surface_halos.hpp"
#include "core/surface/data/surface.hpp"
#include "core/surface/search/bins.hpp"

namespace thaw {

/// Separate table for rounds in which few surfels are open (to be inspected). Placing, sorting and listing
/// all surfels would cost more than the round. The table holds all surfels within `radius` of the initially
/// open ones, on the ranks that own them. Neighbourhoods are complete within `radius` less the reach of an
/// inspection.
struct ActiveSet {
  std::int64_t few = 12;  ///< the set is used if less than one surfel in this many is open; 0: never
  bool taken = false;
  Surfels surfels;
  CellTable cells;
  std::vector<std::uint32_t> rows;  ///< rows of Surface::surfels in the set, outdated while the set is in use
  double deepest = 0;               ///< m, Surfels::depth up to which surfels may be inspected
};

/// Extracts the active set. `open` flags all rows, ghosts included. Surface::surfels loses its ghosts.
/// Surfels of the set have no order and no ghosts. Requires: ghosts and bins of Surface::surfels.
void extractActiveSet(Surface& surface, const Bins& bins, const std::vector<std::uint8_t>& open,
                      double radius, double reach, ActiveSet& region);

/// Returns whether all open surfels have complete neighbourhoods, on all ranks. Collective.
bool activeSetSuffices(const ActiveSet& region, Reducer& all);

/// Returns the surfels of the active set to Surface::surfels, which has no order afterwards.
void returnActiveSet(Surface& surface, ActiveSet& region);

}  // namespace thaw
