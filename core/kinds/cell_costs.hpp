// What the cells of a rank cost, rows of all kinds together: what the partition is cut by.
#pragma once
#include <array>
#include <vector>

#include "core/kinds/kinds.hpp"

namespace thaw {

struct CellCosts {
  CellTable cells;           ///< owned, ascending by key; only keys and their number are filled in
  std::vector<double> cost;  ///< beside cells.key
};

/// Cost of one row, in any unit, > 0: of a liquid and of a solid particle of the continuum, and of each kind.
struct RowCosts {
  double liquid = 1, solid = 1;
  std::array<double, kindCount> kind;
  RowCosts() { kind.fill(1); }
};
CellCosts costOfCells(const World& world, const RowCosts& costs);

/// Every row costs the same.
inline CellCosts countCells(const World& world) { return costOfCells(world, {}); }

}  // namespace thaw
