// The few surfels that later rounds of resampling look at, with what is around them.
#pragma once
#include <vector>

#include "core/halo/surface_halos.hpp"
#include "core/surface/bins.hpp"
#include "core/surface/surface.hpp"

namespace thaw {

/// A table of its own for rounds in which few surfels are open (looked at): to place, sort and list all the
/// others in each round would cost more than the round. It holds all surfels within `radius` of what was open
/// when it was taken, on the ranks that own them, and all that a round needs of those within radius less the
/// reach of a look.
struct OpenRegion {
  std::int64_t few = 12;  ///< it is taken where less than one surfel in so many is open; 0: never
  bool taken = false;
  Surfels surfels;
  CellTable cells;
  std::vector<std::uint32_t> rows;  ///< of Surface::surfels that are in it; they are stale as long as it is
                                    ///< taken
  double deepest = 0;               ///< m, Surfels::depth up to which surfels can be looked at
};

/// open: of all rows, ghosts included. Surface::surfels has ghosts and bins; it loses the ghosts. Surfels of
/// the region have no order and no ghosts.
void takeRegion(Surface& surface, const Bins& bins, const std::vector<std::uint8_t>& open, double radius,
                double reach, OpenRegion& region);

/// Is all that is open deep enough in it, on all ranks? Collective.
bool regionHolds(const OpenRegion& region, Reducer& all);

/// Puts the region's surfels back; Surface::surfels has no order then.
void returnRegion(Surface& surface, OpenRegion& region);

}  // namespace thaw
