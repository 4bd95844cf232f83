// Neighbours of rows of one table among the rows of another, or the same: surfels around surfels, particles around surfels.
#pragma once
#include <cstdint>
#include <vector>

#include "core/math/vec3.hpp"
#include "core/neighbours/grid.hpp"

namespace thaw {

/// Neighbours of owned row i: row[first[i]] ... row[first[i + 1] - 1], in the order of the 27 cells (z, y, x ascending) and by id within.
struct RowLists {
  std::vector<std::uint64_t> first;
  std::vector<std::uint32_t> row;
};

/// Rows of `to` (sorted by (cell, id), ghosts included) within `radius` (m, at most the grid's edge) of each of the first `owned` rows of
/// `from`, which lie in cells of the same grid on this rank. A row is not its own neighbour where both are one table (same == true).
void findRows(const CellGrid& grid, const CellTable& fromCells, const Vec3d* from, std::size_t owned, const CellTable& toCells, const Vec3d* to, double radius,
              bool same, RowLists& lists);

}  // namespace thaw
