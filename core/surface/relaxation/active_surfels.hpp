// SPDX-License-Identifier: Apache-2.0
// Selects the surfels that the iterations of an update work on (local work, K05 section 5). Work begins with
// the surfels that the forces may move. It shrinks to moving surfels and their surroundings.
#pragma once
#include <cstdint>
#include <vector>

#include "core/halo/halo.hpp"
#include "core/surface/data/surface.hpp"
#include "core/surface/search/bins.hpp"

namespace thaw {

/// Flags the owned surfels that the forces may move; with `all` every one. Surfels of drops with at most
/// smallDrop particles are left out. They form spheres (renewSurfels), and the colour field between two such
/// drops would tear them apart.
void markFree(const Surface& surface, bool all, std::vector<std::uint8_t>& free);

/// Narrows `free` to the surfels that may move before the next search. `core`: a moving surfel lies within
/// `reach` (m, at most the grid's edge). `free`: a surfel of the core lies within `reach`. Motion of a surfel
/// outside the core may reach beyond the lists. Changes Surfels::resampleFlags. Requires: ghosts with
/// Surfels::moving; bins of all rows. Collective.
void markActive(Surface& surface, CellHalo& halo, const Bins& bins, double reach,
                std::vector<std::uint8_t>& free, std::vector<std::uint8_t>& core);

}  // namespace thaw
