// SPDX-License-Identifier: Apache-2.0
// Sorting of particles into (cell, id) order, the order of all neighbour sums.
#pragma once
#include <cstdint>
#include <vector>

#include "core/neighbours/grid.hpp"
#include "core/neighbours/migration.hpp"
#include "core/particles/continuum.hpp"

namespace thaw {

/// Buffers of the sort, reused in each step.
struct SortBuffers {
  std::vector<std::uint32_t> gone;    ///< rows that leave their position, ascending: departed, or in another
                                      ///< cell
  std::vector<std::uint32_t> movers;  ///< rows with a new position: moved rows that stay on this rank, and
                                      ///< arrivals
  std::vector<std::uint32_t> before;  ///< per mover: the row that it precedes
  std::vector<std::uint32_t> order;   ///< used if most rows move: old row of each row
  RowMoves moves;
};

/// Computes the cell keys of rows [begin, end) into particles.nextCell.
/// Rows: a table with columns id, position, cell and nextCell (Continuum, Surfels, SurfaceParticles,
/// BodyTypeRows).
template<class Rows>
void computeCellKeys(const CellGrid& grid, Rows& particles, std::size_t begin, std::size_t end);
template<class Rows> void computeCellKeys(const CellGrid& grid, Rows& particles) {
  computeCellKeys(grid, particles, 0, particles.owned);
}

/// Sorts the owned rows by (cell, id) and drops departed rows. Only rows that changed their cell are sorted;
/// the others are merged. Requires: nextCell of all owned rows, and ascending cells of the rows present at
/// the last sort. Ensures: cell equals the former nextCell, ascending, with ascending ids within a cell; no
/// ghosts; `cells` lists the occupied cells. nextCell and the stale columns are undefined until they are
/// written again.
template<class Rows>
void sortByCell(Rows& particles, const Migration& migration, SortBuffers& buffers, CellTable& cells,
                std::span<AnyColumn* const> stale = {});

/// Drops the departed rows if the order does not matter. The last rows fill the gaps. Moved and arrived rows
/// get noCell as their last cell, so the next sort moves them.
void closeGaps(Continuum& particles, const Migration& migration);

}  // namespace thaw
