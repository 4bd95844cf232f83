// SPDX-License-Identifier: Apache-2.0
// Definitions of the sort for any table of rows. A source file includes this to instantiate them for a table.
#pragma once
#include <algorithm>

#include "core/fields/table_rows.hpp"
#include "core/neighbours/list_cells.hpp"
#include "core/neighbours/sort.hpp"

namespace thaw {

template<class Rows> void computeCellKeys(const CellGrid& grid, Rows& p, std::size_t begin, std::size_t end) {
  const CellGrid g = grid;
  const Vec3d* position = p.position.data();
  std::uint64_t* next = p.nextCell.data();
  for (std::size_t i = begin; i < end; i++) next[i] = cellKey(cellOf(g, position[i]));
}

namespace sorting {

/// Lists the cells of rows with ascending keys.
void listRuns(const std::uint64_t* key, std::size_t rows, CellTable& cells);

/// Lists the runs of rows between leaving rows and insertion points.
void listMoves(SortBuffers& b, std::size_t stayed);

/// Releases the memory that only a sort of most rows needs.
void shrink(SortBuffers& b);

/// Finds the rows that leave their position and the rows that get a new position. It marks departed rows in
/// nextCell.
template<class Rows> void findMovers(Rows& p, const Migration& migration, SortBuffers& b) {
  const std::size_t stayed = p.owned - migration.arrivals;
  b.gone.clear();
  b.movers.clear();
  for (const std::uint32_t row : migration.departed) p.nextCell[row] = noCell;
  const std::uint64_t *next = p.nextCell.data(), *last = p.cell.data();
  for (std::size_t i = 0; i < stayed; i++)
    if (next[i] != last[i] || next[i] == noCell) {
      b.gone.push_back(static_cast<std::uint32_t>(i));
      if (next[i] != noCell) b.movers.push_back(static_cast<std::uint32_t>(i));
    }
  for (std::size_t i = stayed; i < p.owned; i++)
    if (next[i] != noCell) b.movers.push_back(static_cast<std::uint32_t>(i));
}

/// Finds for each sorted mover the first kept row behind it, or `stayed`. The search uses doubling strides
/// from the previous mover.
template<class Before>
void findPlaces(SortBuffers& b, std::size_t stayed, const std::uint64_t* next, const std::uint64_t* last,
                const Before& before) {
  const auto keeps = [&](std::size_t row) { return next[row] == last[row] && next[row] != noCell; };
  b.before.resize(b.movers.size());
  std::size_t from = 0;  // all earlier rows precede the mover
  for (std::size_t m = 0; m < b.movers.size(); m++) {
    std::size_t low = from, high = stayed, stride = 1;  // the first row behind the mover is in [low, high]
    const auto firstKept = [&](std::size_t row, std::size_t end) {
      while (row < end && !keeps(row)) row++;
      return row;
    };
    for (std::size_t probe = low; probe < stayed; probe = low + stride, stride *= 2) {
      const std::size_t row = firstKept(probe, stayed);
      if (row == stayed) break;
      if (before(b.movers[m], static_cast<std::uint32_t>(row))) {
        high = row;
        break;
      }
      low = row + 1;
    }
    while (low < high) {
      const std::size_t middle = low + (high - low) / 2, row = firstKept(middle, high);
      if (row == high) high = middle;
      else if (before(b.movers[m], static_cast<std::uint32_t>(row))) high = row;
      else low = row + 1;
    }
    from = low;
    b.before[m] = static_cast<std::uint32_t>(low);
  }
}

/// Computes the old row of each new row, for sorts that move many rows.
template<class Before> void mergeAll(SortBuffers& b, std::size_t stayed, const Before& before) {
  b.before.clear();  // reused for the rows that keep their order
  for (std::size_t row = 0, gone = 0; row < stayed; row++) {
    if (gone < b.gone.size() && b.gone[gone] == row) gone++;
    else b.before.push_back(static_cast<std::uint32_t>(row));
  }
  b.order.resize(b.before.size() + b.movers.size());
  std::merge(b.before.begin(), b.before.end(), b.movers.begin(), b.movers.end(), b.order.begin(), before);
}

}  // namespace sorting

template<class Rows> void listCells(const Rows& p, CellTable& cells) {
  sorting::listRuns(p.nextCell.data(), p.owned, cells);
}

template<class Rows>
void sortByCell(Rows& p, const Migration& migration, SortBuffers& b, CellTable& cells,
                std::span<AnyColumn* const> stale) {
  constexpr std::size_t shortRun = 8;  // mean number of rows between moves; if it is smaller, a gather of all
                                       // columns is faster
  const std::size_t stayed = p.owned - migration.arrivals;
  if (p.ghosts > 0) p.resize(p.owned, 0);
  sorting::findMovers(p, migration, b);
  if (!b.movers.empty() || !b.gone.empty() || stayed != p.owned) {  // the last condition is for arrivals that
                                                                    // departed at once
    const std::uint64_t *next = p.nextCell.data(), *id = p.id.data();
    const auto before = [&](std::uint32_t i, std::uint32_t j) {
      return next[i] != next[j] ? next[i] < next[j] : id[i] < id[j];
    };
    std::sort(b.movers.begin(), b.movers.end(), before);
    ColumnList unmoved{&p.nextCell};
    for (AnyColumn* c : stale) unmoved.push_back(c);
    const bool few = (b.movers.size() + b.gone.size()) * shortRun < p.owned;
    if (few) sorting::findPlaces(b, stayed, next, p.cell.data(), before);
    else sorting::mergeAll(b, stayed, before);
    for (const std::uint32_t row : b.movers) p.cell[row] = next[row];
    if (few) {
      if (b.order.capacity() > 0) sorting::shrink(b);  // buffer of the initial full sort
      sorting::listMoves(b, stayed);
      p.rearrange(b.moves, unmoved);
    } else {
      p.reorder(b.order, unmoved);
    }
  }
  sorting::listRuns(p.cell.data(), p.owned, cells);
}

}  // namespace thaw
