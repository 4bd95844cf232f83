// SPDX-License-Identifier: Apache-2.0
// Selects the surfels for the iterations of an update (local work, K05 section 5). The first iteration
// includes all surfels that the forces may move. Later iterations include only moving surfels and their
// surroundings.
#pragma once
#include <cstdint>
#include <vector>

#include "core/halo/halo.hpp"
#include "core/surface/data/surface.hpp"
#include "core/surface/search/bins.hpp"

namespace thaw {

/// Flags the owned surfels that the forces may move; with `all`, every surfel. Surfels of drops with at most
/// smallDrop particles are excluded. They form spheres (renewSurfels), and the colour field between two such
/// drops would deform them.
void markFree(const Surface& surface, bool all, std::vector<std::uint8_t>& free);

/// Restricts `free` to the surfels that may move before the next search. A surfel is in `core` if a moving
/// surfel lies within `reach` (m, at most the grid's edge). It stays in `free` if a surfel of the core lies
/// within `reach`. If a surfel outside the core moves, the lists may be incomplete. Changes
/// Surfels::resampleFlags. Requires: ghosts with Surfels::moving; bins of all rows. Collective.
void markActive(Surface& surface, CellHalo& halo, const Bins& bins, double reach,
                std::vector<std::uint8_t>& free, std::vector<std::uint8_t>& core);

}  // namespace thaw
