// What the cells of a rank cost, rows of all kinds together: what the partition is cut by.
#pragma once
#include <array>
#include <vector>

#include "core/kinds/kinds.hpp"

namespace thaw {

struct CellCosts {
  CellTable cells;            ///< owned, ascending by key; only keys and their number are filled in
  std::vector<double> cost;   ///< beside cells.key
};

/// perParticle, perRow: cost of one row of the continuum and of each kind, in any unit, > 0.
CellCosts costOfCells(const World& world, double perParticle, const std::array<double, kindCount>& perRow);

/// Every row costs the same.
inline CellCosts countCells(const World& world) {
  std::array<double, kindCount> one;
  one.fill(1);
  return costOfCells(world, 1, one);
}

}  // namespace thaw
