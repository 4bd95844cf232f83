// Neighbours of rows of a table among all its rows: surfels around surfels.
#pragma once
#include <cstdint>
#include <vector>

#include "core/math/vec3.hpp"
#include "core/surface/bins.hpp"

namespace thaw {

/// Neighbours of owned row i: row[first[i]] ... row[end[i] - 1], in the order of bins.
struct RowLists {
  std::vector<std::uint64_t> first, end;
  std::vector<std::uint32_t> row;
  RowBlock block;
};

/// Rows (of the bins' table, ghosts included) within `radius` (m) of each of the first `owned` rows that is
/// wanted; the others have none. A row is not its own neighbour. `position` as when the bins were filled.
void findRows(const Bins& bins, const Vec3d* position, std::size_t owned,
              const std::vector<std::uint8_t>& wanted, double radius, RowLists& lists);

}  // namespace thaw
