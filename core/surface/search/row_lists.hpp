// SPDX-License-Identifier: Apache-2.0
// Neighbour lists of the rows of a table.
#pragma once
#include <cstdint>
#include <vector>

#include "core/math/vec3.hpp"
#include "core/surface/search/bins.hpp"

namespace thaw {

/// Neighbours of owned row i: row[first[i]] ... row[end[i] - 1], in the order of bins.
struct RowLists {
  std::vector<std::uint64_t> first, end;
  std::vector<std::uint32_t> row;
  RowBlock block;
};

/// Finds the rows (ghosts included) within `radius` (m) of each wanted row among the first `owned` ones.
/// Other rows have empty lists. A row is not its own neighbour. Requires: `position` as when the bins were
/// filled.
void findRows(const Bins& bins, const Vec3d* position, std::size_t owned,
              const std::vector<std::uint8_t>& wanted, double radius, RowLists& lists);

}  // namespace thaw
