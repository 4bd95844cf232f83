// Which surfels an update's iterations work on: local work (K05 5, future work) begins with those that the
// forces may move, and shrinks to those that still move and what they have in reach.
#pragma once
#include <cstdint>
#include <vector>

#include "core/halo/halo.hpp"
#include "core/surface/bins.hpp"
#include "core/surface/surface.hpp"

namespace thaw {

/// A flag for each owned surfel that the forces may move; `all`: every one. Not those of drops of at most
/// smallDrop particles, which are spheres (renewSurfels): the colour field between two of them would tear
/// them apart.
void markFree(const Surface& surface, bool all, std::vector<std::uint8_t>& free);

/// Narrows `free` to what may be worked on before the next search: `core` has a surfel that moves within
/// `reach` (m, at most the grid's edge), the others have one of the core within it. Once one of the others
/// moves, work may spread past what is listed. Needs ghosts with Surfels::moving, and bins of all rows.
/// Changes Surfels::wish. Collective.
void markActive(Surface& surface, CellHalo& halo, const Bins& bins, double reach,
                std::vector<std::uint8_t>& free, std::vector<std::uint8_t>& core);

}  // namespace thaw
