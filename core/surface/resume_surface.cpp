// SPDX-License-Identifier: Apache-2.0
#include "core/surface/resume_surface.hpp"

namespace thaw {
namespace {

/// Sorts rows by (cell, id) without migration.
template<class Rows>
void sortInPlace(const CellGrid& grid, Rows& rows, CellTable& cells, SortBuffers& buffers) {
  computeCellKeys(grid, rows);
  Migration all;
  all.arrivals = rows.owned;
  sortByCell(rows, all, buffers, cells);
}

/// Partitions the domain by owned rows, without ghost cells in `cells`. Returns whether the partition
/// changed.
template<class Rows>
bool partitionByRows(const Rows& rows, const CellTable& cells, SurfaceHalos halos, bool force) {
  CellTable own;
  std::vector<double> cost;
  for (std::size_t c = 0; c < cells.key.size(); c++) {
    if (cells.first[c] >= rows.owned) continue;
    own.key.push_back(cells.key[c]);
    own.first.push_back(cells.first[c]);
    own.count.push_back(cells.count[c]);
    cost.push_back(cells.count[c]);
  }
  own.ownedCells = own.key.size();
  const bool anew = halos.surfels.rebalance(own, cost, force);
  if (anew) halos.particles.follow(halos.surfels);
  return anew;
}

}  // namespace

void resumeSurface(Surface& surface, SurfaceHalos halos, SurfaceTools& t) {
  balanceSurface(surface, halos, t, true);
}

void balanceSurface(Surface& s, SurfaceHalos halos, SurfaceTools& t, bool force) {
  // Births and deaths may have occurred since the last sort.
  sortInPlace(s.grid, s.surfels, s.surfelCells, t.sort);
  partitionByRows(s.surfels, s.surfelCells, halos, force);
}

void partitionByParticles(Surface& s, SurfaceHalos halos, SurfaceTools& t) {
  sortInPlace(s.grid, s.particles, s.particleCells, t.sort);
  partitionByRows(s.particles, s.particleCells, halos, true);
}

void emptySurface(Surface& s) {
  for (Table* table : {static_cast<Table*>(&s.surfels), static_cast<Table*>(&s.particles)}) {
    table->resize(table->owned, 0);
    table->resize(0, 0);
  }
  s.surfelCells = {};
  s.particleCells = {};
  s.components.clear();
  s.events.clear();
  s.counters = {};
  s.lastStep = -1;
}

}  // namespace thaw
