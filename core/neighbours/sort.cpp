// SPDX-License-Identifier: Apache-2.0
#include "core/neighbours/sort.hpp"

#include <algorithm>

#include "core/fields/table_rows.hpp"
#include "core/neighbours/sort_rows.hpp"
#include "core/particles/body_type_rows.hpp"

namespace thaw {
namespace sorting {

void listRuns(const std::uint64_t* key, std::size_t rows, CellTable& cells) {
  cells.key.clear();
  cells.first.clear();
  cells.count.clear();
  for (std::size_t i = 0; i < rows; i++) {
    if (cells.key.empty() || cells.key.back() != key[i]) {
      cells.key.push_back(key[i]);
      cells.first.push_back(static_cast<std::uint32_t>(i));
      cells.count.push_back(0);
    }
    cells.count.back()++;
  }
  cells.ownedCells = cells.key.size();
}

void listMoves(SortBuffers& b, std::size_t stayed) {
  RowMoves& moves = b.moves;
  moves.runs.clear();
  moves.singles.clear();
  std::size_t row = 0, to = 0, gone = 0, mover = 0;
  while (row < stayed || mover < b.movers.size()) {
    while (mover < b.movers.size() && b.before[mover] <= row)
      moves.singles.push_back({b.movers[mover++], static_cast<std::uint32_t>(to++)});
    if (row == stayed) continue;
    if (gone < b.gone.size() && b.gone[gone] == row) {
      gone++, row++;
      continue;
    }
    const std::size_t end = std::min<std::size_t>(gone < b.gone.size() ? b.gone[gone] : stayed,
                                                  mover < b.movers.size() ? b.before[mover] : stayed);
    moves.runs.push_back({static_cast<std::uint32_t>(row), static_cast<std::uint32_t>(to),
                          static_cast<std::uint32_t>(end - row)});
    to += end - row;
    row = end;
  }
  moves.rows = to;
}

void shrink(SortBuffers& b) {
  b.order = {};
  for (auto* v : {&b.gone, &b.movers, &b.before}) v->shrink_to_fit();
}

}  // namespace sorting

void closeGaps(Continuum& p, const Migration& migration) {
  std::fill(p.cell.data() + p.owned - migration.arrivals, p.cell.data() + p.owned, noCell);
  std::size_t rows = p.owned;
  for (std::size_t k = migration.departed.size(); k-- > 0;) {
    const std::size_t gap = migration.departed[k];
    if (gap != --rows) {  // processed from the end: later departed rows are gone, so the last row is a kept
                          // one
      copyRow(p, rows, gap);
      p.cell[gap] = noCell;
    }
  }
  p.resize(rows, 0);
}

template void computeCellKeys(const CellGrid&, Continuum&, std::size_t, std::size_t);
template void computeCellKeys(const CellGrid&, BodyTypeRows&, std::size_t, std::size_t);
template void listCells(const Continuum&, CellTable&);
template void sortByCell(Continuum&, const Migration&, SortBuffers&, CellTable&, std::span<AnyColumn* const>);
template void sortByCell(BodyTypeRows&, const Migration&, SortBuffers&, CellTable&,
                         std::span<AnyColumn* const>);

}  // namespace thaw
