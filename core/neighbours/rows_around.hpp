// SPDX-License-Identifier: Apache-2.0
// Rows of a table in the cells around a cell.
#pragma once
#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "core/neighbours/grid.hpp"
#include "core/particles/row_span.hpp"

namespace thaw {

/// Appends the rows in the 27 cells around a cell, ascending by (cell, id).
inline void rowsAround(const CellTable& t, std::uint64_t key, std::vector<RowSpan>& ranges) {
  ranges.clear();
  const Vec3i c = cellOfKey(key);
  for (int z = -1; z <= 1; z++)
    for (int y = -1; y <= 1; y++) {
      const std::uint64_t last = cellKey({c.x + 1, c.y + y, c.z + z});
      auto at = std::lower_bound(t.key.begin(), t.key.end(), cellKey({c.x - 1, c.y + y, c.z + z}));
      for (; at != t.key.end() && *at <= last; ++at) {
        const auto k = static_cast<std::size_t>(at - t.key.begin());
        ranges.push_back({t.first[k], t.first[k] + t.count[k]});
      }
    }
}

/// Calls use(i, ranges) for each owned row i of one table for which wanted(i) is true. ranges: rows of the
/// other table in the surrounding cells. The surrounding rows are listed only for cells with such a row i.
template<class Wanted, class Use>
void eachSurrounded(const CellTable& own, std::size_t owned, const CellTable& others, Wanted&& wanted,
                    Use&& use) {
  std::vector<RowSpan> ranges;
  for (std::size_t c = 0; c < own.key.size(); c++) {
    if (own.first[c] >= owned) continue;
    bool listed = false;
    for (std::uint32_t i = own.first[c]; i < own.first[c] + own.count[c]; i++) {
      if (!wanted(i)) continue;
      if (!listed) rowsAround(others, own.key[c], ranges);
      listed = true;
      use(i, std::span<const RowSpan>(ranges));
    }
  }
}

/// Calls pair(i, j) for each owned row i of one table and each row j of the other in the surrounding cells.
/// For each i, the rows j are in (cell, id) order.
template<class Pair>
void eachNear(const CellTable& own, std::size_t owned, const CellTable& others, Pair&& pair) {
  eachSurrounded(
      own, owned, others, [](std::uint32_t) { return true; },
      [&](std::uint32_t i, std::span<const RowSpan> ranges) {
        for (const RowSpan& r : ranges)
          for (std::uint32_t j = r.begin; j < r.end; j++) pair(i, j);
      });
}

}  // namespace thaw
