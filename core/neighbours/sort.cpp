#include "core/neighbours/sort.hpp"

#include <algorithm>
#include <cstring>
#include <numeric>

#include "core/kinds/kind_rows.hpp"
#include "core/neighbours/list_cells.hpp"
#include "core/particles/table_rows.hpp"
#include "core/surface/surfels.hpp"

namespace thaw {

template<class Rows> void computeCellKeys(const CellGrid& grid, Rows& p, std::size_t begin, std::size_t end) {
  for (std::size_t i = begin; i < end; i++) p.nextCell[i] = cellKey(cellOf(grid, p.position[i]));
}

template<class Rows> void listCells(const Rows& p, CellTable& cells) {
  cells.key.clear();
  cells.first.clear();
  cells.count.clear();
  for (std::size_t i = 0; i < p.owned; i++) {
    if (cells.key.empty() || cells.key.back() != p.nextCell[i]) {
      cells.key.push_back(p.nextCell[i]);
      cells.first.push_back(static_cast<std::uint32_t>(i));
      cells.count.push_back(0);
    }
    cells.count.back()++;
  }
  cells.ownedCells = cells.key.size();
}

template<class Rows> void sortByCell(Rows& p, const Migration& migration, SortBuffers& b, CellTable& cells) {
  const std::size_t stayed = p.owned - migration.arrivals;
  const std::uint64_t* next = p.nextCell.data();
  const std::uint64_t* id = p.id.data();
  const auto before = [&](std::uint32_t i, std::uint32_t j) { return next[i] != next[j] ? next[i] < next[j] : id[i] < id[j]; };

  b.movers.clear();
  if (b.order.capacity() < p.owned) b.order.reserve(p.owned + p.owned / 16);
  b.order.resize(p.owned);
  std::size_t departed = 0, stayers = 0;
  for (std::size_t i = 0; i < p.owned; i++) {
    const std::uint32_t row = static_cast<std::uint32_t>(i);
    if (departed < migration.departed.size() && migration.departed[departed] == row) {
      departed++;
      continue;
    }
    if (i < stayed && next[i] == p.cell[i]) b.order[stayers++] = row;
    else b.movers.push_back(row);
  }

  if (!b.movers.empty() || stayers != p.owned) {
    std::sort(b.movers.begin(), b.movers.end(), before);
    // Merged from behind, in place: the stayers are already in order. Those behind a mover are looked for in strides that double, then moved at once.
    std::uint32_t* const order = b.order.data();
    std::size_t a = stayers;
    for (std::size_t m = b.movers.size(); m-- > 0;) {
      const std::uint32_t mover = b.movers[m];
      std::size_t low = a, high = a, stride = 1;  // the first stayer behind the mover is in [low, high]
      while (low > 0 && before(mover, order[low - 1])) {
        high = low - 1;
        low -= std::min(low, stride);
        stride *= 2;
      }
      const std::size_t first = static_cast<std::size_t>(std::partition_point(order + low, order + high, [&](std::uint32_t row) { return before(row, mover); }) - order);
      std::memmove(order + first + m + 1, order + first, (a - first) * sizeof *order);
      order[first + m] = mover;
      a = first;
    }
    b.order.resize(stayers + b.movers.size());
    p.reorder(b.order);
    std::copy_n(p.nextCell.data(), p.owned, p.cell.data());
  } else {
    p.resize(p.owned, 0);
  }
  listCells(p, cells);
}

void closeGaps(Continuum& p, const Migration& migration) {
  std::fill(p.cell.data() + p.owned - migration.arrivals, p.cell.data() + p.owned, noCell);
  std::size_t rows = p.owned;
  for (std::size_t k = migration.departed.size(); k-- > 0;) {
    const std::size_t gap = migration.departed[k];
    if (gap != --rows) {  // from behind: what departed after it has gone already, so that the last row stays
      copyRow(p, rows, gap);
      p.cell[gap] = noCell;
    }
  }
  p.resize(rows, 0);
}

template void computeCellKeys(const CellGrid&, Continuum&, std::size_t, std::size_t);
template void computeCellKeys(const CellGrid&, Surfels&, std::size_t, std::size_t);
template void computeCellKeys(const CellGrid&, SurfaceParticles&, std::size_t, std::size_t);
template void computeCellKeys(const CellGrid&, KindRows&, std::size_t, std::size_t);
template void listCells(const Continuum&, CellTable&);
template void sortByCell(Continuum&, const Migration&, SortBuffers&, CellTable&);
template void sortByCell(Surfels&, const Migration&, SortBuffers&, CellTable&);
template void sortByCell(SurfaceParticles&, const Migration&, SortBuffers&, CellTable&);
template void sortByCell(KindRows&, const Migration&, SortBuffers&, CellTable&);

}  // namespace thaw
