// Neighbour search over the sorted cells.
#pragma once
#include <cstdint>
#include <vector>

#include "core/neighbours/grid.hpp"
#include "core/neighbours/neighbour_lists.hpp"

namespace thaw {

/// Buffers of a search, reused from step to step.
struct SearchBuffers {
  AlignedVector<float> x, y, z;              ///< candidates around a cell, relative to its first particle, in support radii
  AlignedVector<std::uint32_t> row;
  AlignedVector<std::uint32_t> found[8];     ///< neighbours of the eight particles of a group
  std::uint32_t length[8]{};
  std::uint32_t self[8]{};
  int filled = 0;
  std::uint8_t wet = 0;
};

/// Room for n candidates around one cell.
void growSearch(SearchBuffers& buffers, std::size_t n);

/// Where the candidates are: place[row] = fixed-point x, y, z (and a fourth value that the search does not read).
struct SearchInput {
  const std::uint32_t* place = nullptr;  ///< 4 words a row
  const CellTable* cells = nullptr;      ///< ascending by key, owned and ghosts
  const std::uint8_t* inner = nullptr;   ///< for each cell: 1 if its sums need no ghosts
  const std::uint8_t* liquid = nullptr;  ///< for each cell: 1 if some particle of it is liquid; nullptr: all are
  std::uint32_t owned = 0;               ///< owned rows
};

/// SearchInput::inner of a cell whose particles get no lists: they sleep (core/sleep/sleep.hpp).
inline constexpr std::uint8_t skippedCell = 2;

/// Which owned cells a search works on.
enum class Part { Inner, Boundary };

/// The search itself is in search_isa.cpp (PairKernels::search): it appends lists for the owned particles of the cells for which
/// inner[c] says so (Part::Inner first, which starts anew, then Part::Boundary). inner: one byte for each cell of input.cells.
/// Neighbours come in the order of the 27 cells (z, y, x ascending) and by id within: the same on any number of ranks.

}  // namespace thaw
