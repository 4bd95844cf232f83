// Neighbour search over the sorted cells.
#pragma once
#include <cstdint>
#include <vector>

#include "core/neighbours/grid.hpp"
#include "core/neighbours/neighbour_lists.hpp"

namespace thaw {

/// Up to 32 rows that follow each other, of the cells around one.
struct SearchRound {
  std::uint32_t first, count;
  std::uint32_t entry;  ///< of the first row (NeighbourLists)
  std::uint32_t keep;   ///< bits of the rows that may be neighbours
};

/// Buffers of a search, reused from step to step.
struct SearchBuffers {
  AlignedVector<std::uint16_t> x, y, z;  ///< candidates around a cell, as in SearchInput
  AlignedVector<std::uint32_t> entry;    ///< of their rows (NeighbourLists)
  AlignedVector<SearchRound> rounds;     ///< of the cells around one
  static constexpr int window = 32;      ///< lists that are put together by their length, so that groups need
                                         ///< little padding
  AlignedVector<std::uint32_t> found[window];  ///< neighbours of as many particles
  std::uint32_t length[window]{};
  std::uint32_t self[window]{};
  std::uint8_t wet[window]{};
  int filled = 0;
};

/// Room for n candidates around one cell.
void growSearch(SearchBuffers& buffers, std::size_t n);
/// Room for twice as many rounds; 64 at first.
void growRounds(SearchBuffers& buffers);

/// Where the candidates are, in 2^-14 support radii, modulo 4 support radii: what is farther is wrapped, but
/// cells that touch are no longer than the difference that stays unique, or what comes back from beyond meets
/// kernels that are zero (coarsePlace, grid.hpp).
struct SearchInput {
  const std::uint16_t *x = nullptr, *y = nullptr, *z = nullptr;  ///< by row; 32 more may be read
  const CellTable* cells = nullptr;                              ///< ascending by key, owned and ghosts
  const std::uint8_t* inner = nullptr;   ///< for each cell: 1 if its sums need no ghosts
  const std::uint8_t* liquid = nullptr;  ///< for each cell: 1 if some particle of it is liquid; nullptr: all
                                         ///< are
  std::uint32_t owned = 0;               ///< owned rows
};

/// SearchInput::inner of a cell whose particles get no lists: they sleep (core/sleep/sleep.hpp).
inline constexpr std::uint8_t skippedCell = 2;

/// Which owned cells a search works on.
enum class Part { Inner, Boundary };

/// The search itself is in search_isa.cpp (PairKernels::search): it appends lists for the owned particles of
/// the cells for which inner[c] says so (Part::Inner first, which starts anew, then Part::Boundary). inner:
/// one byte for each cell of input.cells. Neighbours come in the order of the 27 cells (z, y, x ascending)
/// and by id within: the same on any number of ranks.

}  // namespace thaw
