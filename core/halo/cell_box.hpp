// SPDX-License-Identifier: Apache-2.0
// Boxes of whole cells: the cells of a rank, and the parts that other ranks copy.
#pragma once
#include <algorithm>

#include "core/neighbours/grid.hpp"

namespace thaw {

/// Cells [min, max) along each axis; empty if max <= min along an axis.
struct CellBox {
  Vec3i min{}, max{};
  bool contains(const Vec3i& c) const {
    return c.x >= min.x && c.x < max.x && c.y >= min.y && c.y < max.y && c.z >= min.z && c.z < max.z;
  }
  bool operator==(const CellBox&) const = default;
  bool empty() const { return max.x <= min.x || max.y <= min.y || max.z <= min.z; }
};

/// Returns the box extended by one layer of cells.
inline CellBox grown(CellBox b) {
  for (int a = 0; a < 3; a++) {
    b.min[a]--;
    b.max[a]++;
  }
  return b;
}
inline CellBox moved(const CellBox& b, const Vec3i& by) { return {b.min + by, b.max + by}; }
/// Returns the cells in both boxes.
inline CellBox common(const CellBox& a, const CellBox& b) {
  CellBox c;
  for (int k = 0; k < 3; k++) {
    c.min[k] = std::max(a.min[k], b.min[k]);
    c.max[k] = std::min(a.max[k], b.max[k]);
  }
  return c;
}

/// Returns true if the 26 cells around `cell` are all in the box and no periodic image touches `cell`.
/// Requires: `cell` is in the box.
inline bool innerCell(const CellGrid& grid, const CellBox& box, const Vec3i& cell) {
  for (int a = 0; a < 3; a++) {
    const bool low = cell[a] > box.min[a] || (box.min[a] == 0 && !grid.periodic[a]);
    const bool high = cell[a] < box.max[a] - 1 || (box.max[a] == grid.cells[a] && !grid.periodic[a]);
    if (!low || !high) return false;
  }
  return true;
}

}  // namespace thaw
