// SPDX-License-Identifier: Apache-2.0
// Cells around which the solids have different values, such as different bodies.
#pragma once
#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "core/neighbours/grid.hpp"
#include "core/neighbours/rows_around.hpp"
#include "core/particles/continuum.hpp"

namespace thaw {

/// Smallest and largest value over the solids in a cell.
struct SolidRange {
  std::uint64_t low = ~std::uint64_t{0}, high = 0;
  void add(const SolidRange& o) { low = std::min(low, o.low), high = std::max(high, o.high); }
  bool mixed() const { return low < high; }
};

/// Work of anyMixedCell.
struct MixedCells {
  std::vector<SolidRange> ranges;  ///< by cell
  std::vector<RowSpan> rows;       ///< temporary
};

/// Finds the range of the solids' values in each cell.
template<class Value>
void rangesOfCells(const CellTable& cells, const Continuum& p, const Column<Value>& values,
                   std::vector<SolidRange>& ranges) {
  ranges.assign(cells.key.size(), {});
  for (std::size_t c = 0; c < ranges.size(); c++)
    for (std::size_t i = cells.first[c]; i < cells.first[c] + cells.count[c]; i++)
      if (p.phase[i] == Solid) ranges[c].add({values[i], values[i]});
}

inline bool anyMixed(std::span<const SolidRange> ranges) {
  SolidRange all;
  for (const SolidRange& r : ranges) all.add(r);
  return all.mixed();
}

/// Range of the 27 cells around a cell.
inline SolidRange rangeAround(const CellTable& cells, std::span<const SolidRange> ranges, std::uint64_t key) {
  const Vec3i at = cellOfKey(key);
  SolidRange around;
  for (int z = -1; z <= 1; z++)
    for (int y = -1; y <= 1; y++) {
      const std::uint64_t last = cellKey({at.x + 1, at.y + y, at.z + z});
      auto k = std::lower_bound(cells.key.begin(), cells.key.end(), cellKey({at.x - 1, at.y + y, at.z + z}));
      for (; k != cells.key.end() && *k <= last; ++k)
        around.add(ranges[static_cast<std::size_t>(k - cells.key.begin())]);
    }
  return around;
}

/// Calls use(cell, rows around it) for cells of owned rows around which solids have different values. Stops
/// and returns true when a call returns true.
template<class Use>
bool anyMixedCell(const CellTable& cells, std::size_t owned, MixedCells& mixed, const Use& use) {
  if (!anyMixed(mixed.ranges)) return false;
  for (std::size_t c = 0; c < mixed.ranges.size(); c++) {
    if (cells.first[c] >= owned) continue;
    if (!rangeAround(cells, mixed.ranges, cells.key[c]).mixed()) continue;
    rowsAround(cells, cells.key[c], mixed.rows);
    if (use(c, std::span<const RowSpan>(mixed.rows))) return true;
  }
  return false;
}

}  // namespace thaw
