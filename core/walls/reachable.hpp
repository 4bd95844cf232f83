// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <vector>

#include "core/neighbours/grid.hpp"
#include "core/walls/walls.hpp"

namespace thaw {

/// Lists the walls within the support radius of some particle of a cell. Cells at the border of the grid may
/// contain particles beyond the grid, so all walls are listed for them.
void findReachable(const CellGrid& grid, const Walls& walls, std::uint64_t key,
                   std::vector<std::uint32_t>& reachable);

}  // namespace thaw
