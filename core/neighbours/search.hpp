// SPDX-License-Identifier: Apache-2.0
// Neighbour search over the sorted cells.
#pragma once
#include <cstdint>
#include <vector>

#include "core/neighbours/grid.hpp"
#include "core/neighbours/neighbour_lists.hpp"

namespace thaw {

/// Up to 32 consecutive rows in the cells around a cell.
struct SearchRound {
  std::uint32_t first, count;
  std::uint32_t entry;  ///< entry of the first row (NeighbourLists)
  std::uint32_t keep;   ///< one bit per row that may be a neighbour
};

/// Buffers of a search, reused in each step.
struct SearchBuffers {
  AlignedVector<std::uint16_t> x, y, z;        ///< candidates around a cell, as in SearchInput
  AlignedVector<std::uint32_t> entry;          ///< entries of their rows (NeighbourLists)
  AlignedVector<SearchRound> rounds;           ///< rounds of the cells around a cell
  static constexpr int window = 32;            ///< number of lists that are sorted by length before grouping,
                                               ///< so that groups need little padding
  AlignedVector<std::uint32_t> found[window];  ///< neighbours of the particles in the window
  std::uint32_t length[window]{};
  std::uint32_t self[window]{};
  std::uint8_t fluid[window]{};
  int filled = 0;
};

/// Makes room for n candidates around one cell.
void growSearch(SearchBuffers& buffers, std::size_t n);
/// Doubles the number of rounds, starting from 64.
void growRounds(SearchBuffers& buffers);

/// Positions of the candidates in 2^-14 support radii, modulo 4 support radii. Differences of positions in
/// touching cells are unique, except for distances at which kernels are zero (coarsePosition, grid.hpp).
struct SearchInput {
  const std::uint16_t *x = nullptr, *y = nullptr, *z = nullptr;  ///< by row; up to 32 further values may be
                                                                 ///< read
  const CellTable* cells = nullptr;                              ///< ascending by key, owned and ghost cells
  const std::uint8_t* inner = nullptr;                           ///< per cell: 1 if its sums need no ghosts
  const std::uint8_t* liquid = nullptr;  ///< per cell: 1 if it contains liquid; nullptr: all cells do
  std::uint32_t owned = 0;               ///< owned rows
};

/// SearchInput::inner of a cell whose particles sleep and get no lists (core/sleep/sleep.hpp).
inline constexpr std::uint8_t skippedCell = 2;

/// Part of the owned cells that a search covers.
enum class Part { Inner, Boundary };

/// PairKernels::search is in search_isa.cpp. It appends lists for the owned particles of the cells that
/// inner[c] selects, one byte per cell of input.cells. Call it first for Part::Inner, which starts new lists,
/// then for Part::Boundary. Neighbours are ordered by cell (z, y, x ascending) and by id within a cell, on
/// any number of ranks.

}  // namespace thaw
