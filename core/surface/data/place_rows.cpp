// SPDX-License-Identifier: Apache-2.0
#include "core/surface/data/place_rows.hpp"

#include <cmath>

#include "core/halo/exchange.hpp"

namespace thaw {

template<class Rows>
void placeRows(const CellGrid& grid, CellHalo& halo, Rows& rows, CellTable& cells, SortBuffers& buffers) {
  rows.resize(rows.owned, 0);
  for (int a = 0; a < 3; a++) {
    if (!grid.periodic[a]) continue;
    const double low = grid.origin[a], length = grid.period[a];
    for (std::size_t i = 0; i < rows.owned; i++) {
      double& x = rows.position[i][a];
      x -= length * std::floor((x - low) / length);
      // due to rounding
      if (x >= low + length) x = low;
    }
  }
  computeCellKeys(grid, rows);
  const Migration moved = halo.migrate(rows, {rows.nextCell.data(), rows.owned});
  computeCellKeys(grid, rows, rows.owned - moved.arrivals, rows.owned);
  sortByCell(rows, moved, buffers, cells);
}

template void placeRows(const CellGrid&, CellHalo&, Surfels&, CellTable&, SortBuffers&);
template void placeRows(const CellGrid&, CellHalo&, SurfaceParticles&, CellTable&, SortBuffers&);

void dropGhosts(Table& rows, CellTable& cells) {
  rows.resize(rows.owned, 0);
  std::size_t kept = 0;
  for (std::size_t c = 0; c < cells.key.size(); c++) {
    if (cells.first[c] >= rows.owned) continue;
    cells.key[kept] = cells.key[c];
    cells.first[kept] = cells.first[c];
    cells.count[kept++] = cells.count[c];
  }
  cells.key.resize(kept);
  cells.first.resize(kept);
  cells.count.resize(kept);
  cells.ownedCells = kept;
}

void addGhosts(CellHalo& halo, Table& rows, CellTable& cells, std::span<AnyColumn* const> columns) {
  // Ghost cells of an earlier call would be sent on as owned ones.
  dropGhosts(rows, cells);
  sendGhosts(halo, rows, cells, columns).wait();
}

void refreshGhosts(CellHalo& halo, Table& rows, std::span<AnyColumn* const> columns) {
  refresh(halo, rows, columns).wait();
}

}  // namespace thaw
