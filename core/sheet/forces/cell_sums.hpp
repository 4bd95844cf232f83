// SPDX-License-Identifier: Apache-2.0
// Exact sums over vertices at low cost: floating-point sums within a cell in id order, exact sums over cells.
// Cells do not depend on the number of ranks, so the sums do not depend on it.
#pragma once
#include "core/math/exact_sum.hpp"
#include "core/neighbours/grid.hpp"

namespace thaw {

/// Adds value(i) of owned rows, sorted by cell as in `cells`. Ghost cells are skipped.
template<class Value>
void addByCell(const CellTable& cells, std::size_t owned, ExactSum& sum, Value&& value) {
  for (std::size_t c = 0; c < cells.key.size(); c++) {
    if (cells.first[c] >= owned) continue;
    double part = 0;
    for (std::size_t i = cells.first[c]; i < cells.first[c] + cells.count[c]; i++) part += value(i);
    if (part != 0) sum.add(part);
  }
}
/// Adds vector values in the same way.
template<class Value>
void addByCell3(const CellTable& cells, std::size_t owned, ExactSum (&sum)[3], Value&& value) {
  for (std::size_t c = 0; c < cells.key.size(); c++) {
    if (cells.first[c] >= owned) continue;
    Vec3d part{};
    for (std::size_t i = cells.first[c]; i < cells.first[c] + cells.count[c]; i++) part += value(i);
    for (int a = 0; a < 3; a++)
      if (part[a] != 0) sum[a].add(part[a]);
  }
}

}  // namespace thaw
