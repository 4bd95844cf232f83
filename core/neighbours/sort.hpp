// Keeps particles in (cell, id) order: the order in which every sum over neighbours is taken.
#pragma once
#include <cstdint>
#include <vector>

#include "core/halo/halo.hpp"
#include "core/neighbours/grid.hpp"
#include "core/particles/continuum.hpp"

namespace thaw {

/// Buffers of the sort, reused from step to step.
struct SortBuffers {
  std::vector<std::uint32_t> gone;  ///< rows that leave their place, ascending: departed, or in another cell
                                    ///< now
  std::vector<std::uint32_t> movers;  ///< rows that get another place: those of them that stay here, and
                                      ///< arrivals
  std::vector<std::uint32_t> before;  ///< of each mover: the row that it comes before
  std::vector<std::uint32_t> order;   ///< where most rows move: old row of each
  RowMoves moves;
};

/// The cell keys of rows [begin, end), into particles.nextCell.
/// Rows: a table with columns id, position, cell and nextCell (Continuum, Surfels, SurfaceParticles,
/// KindRows).
template<class Rows>
void computeCellKeys(const CellGrid& grid, Rows& particles, std::size_t begin, std::size_t end);
template<class Rows> void computeCellKeys(const CellGrid& grid, Rows& particles) {
  computeCellKeys(grid, particles, 0, particles.owned);
}

/// Sorts the owned rows by (cell, id) and drops the departed ones. Needs nextCell of all owned rows and, of
/// the rows that were there at the last sort, cell in ascending order. Only the rows that changed their cell
/// are sorted; the others are merged. Guarantees: cell is what nextCell was, ascending, ids ascending within
/// a cell; no ghosts; `cells` lists the occupied cells. nextCell is stale from then on, like the columns that
/// the caller names: nobody reads them before they are written.
template<class Rows>
void sortByCell(Rows& particles, const Migration& migration, SortBuffers& buffers, CellTable& cells,
                std::span<AnyColumn* const> stale = {});

/// Drops the departed rows where nobody asks for the order: the last ones take their places. What has a new
/// place, and what has come, has noCell for its last cell, so that the next sort moves it.
void closeGaps(Continuum& particles, const Migration& migration);

}  // namespace thaw
