// SPDX-License-Identifier: Apache-2.0
// Cost of a rank's cells over all body types, for the domain decomposition.
#pragma once
#include <array>
#include <vector>

#include "core/simulation/world/body_types.hpp"

namespace thaw {

struct CellCosts {
  CellTable cells;           ///< owned cells, ascending by key; only the keys and the number of cells are set
  std::vector<double> cost;  ///< parallel to cells.key
};

/// Cost of a row, > 0, in an arbitrary unit, for liquid and solid continuum particles and for each body type.
struct RowCosts {
  double liquid = 1, solid = 1;
  std::array<double, bodyTypeCount> bodyType;
  RowCosts() { bodyType.fill(1); }
};
CellCosts costOfCells(const World& world, const RowCosts& costs);

/// Returns the number of rows per cell as the cost.
inline CellCosts countCells(const World& world) { return costOfCells(world, {}); }

}  // namespace thaw
