// SPDX-License-Identifier: Apache-2.0
#include "core/oriented/adaptive_sampling/redistribute_oriented.hpp"

#include <algorithm>

#include "core/oriented/forces/oriented_forces.hpp"

namespace thaw {

void redistributeOriented(OrientedBodies& oriented, const CellGrid& grid, Halos halos, SortBuffers& sort) {
  Oriented& o = oriented.rows;
  if (o.ghosts > 0) o.resize(o.owned, 0);
  computeCellKeys(grid, static_cast<BodyTypeRows&>(o));
  // Rows born since the last sort are at the end, without a cell; sortByCell treats them as arrivals.
  std::size_t fresh = 0;
  while (fresh < o.owned && o.cell[o.owned - 1 - fresh] == 0) fresh++;
  std::vector<std::uint32_t> dead;
  for (std::size_t i = 0; i < o.owned; i++)
    if (o.mass[i] == 0) {
      o.nextCell[i] = noCell;
      dead.push_back(static_cast<std::uint32_t>(i));
    }
  const std::size_t before = o.owned;
  Migration m = halos.bodyTypes[orientedType]->migrate(o, {o.nextCell.data(), o.owned});
  computeCellKeys(grid, static_cast<BodyTypeRows&>(o), before, o.owned);
  std::vector<std::uint32_t> gone;
  std::merge(m.departed.begin(), m.departed.end(), dead.begin(), dead.end(), std::back_inserter(gone));
  m.departed = std::move(gone);
  m.arrivals += fresh;
  sortByCell(static_cast<BodyTypeRows&>(o), m, sort, oriented.cells);
}

void redistributeAndUpdate(const OrientedView& w, Halos halos) {
  redistributeOriented(w.oriented, w.grid, halos, w.sort);
  updateNeighbours(w.oriented, w.scene, halos, w.work.lists);
}

}  // namespace thaw
