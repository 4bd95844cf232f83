// Exact sums over vertices at the price of plain ones: plain within a cell, in the order of ids, and exact
// over cells. Cells are the same on any number of ranks, and so are these sums.
#pragma once
#include "core/math/exact_sum.hpp"
#include "core/neighbours/grid.hpp"

namespace thaw {

/// value(i) of all owned rows, sorted by cell as `cells` says. Row ranges of ghost cells are left out.
template<class Value>
void addByCell(const CellTable& cells, std::size_t owned, ExactSum& sum, Value&& value) {
  for (std::size_t c = 0; c < cells.key.size(); c++) {
    if (cells.first[c] >= owned) continue;
    double part = 0;
    for (std::size_t i = cells.first[c]; i < cells.first[c] + cells.count[c]; i++) part += value(i);
    if (part != 0) sum.add(part);
  }
}
/// The same of vectors.
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
