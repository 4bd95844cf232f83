// SPDX-License-Identifier: Apache-2.0
// Neighbours of every owned particle in (cell, id) order, interleaved by groups of 8 particles (sliced
// ELLPACK). Entry n of lane l of group g is list[first[g] + 8 n + l]. The dummy row pads the lists. The
// value of an entry is twice the row (ByEntry, core/simd/lanes.hpp).
#pragma once
#include <cstdint>

#include "core/fields/column.hpp"

namespace thaw {

struct NeighbourLists {
  AlignedVector<std::uint32_t> self;   ///< 8 rows per group; the dummy row pads the last group of each part
  AlignedVector<std::uint64_t> first;  ///< start of a group in list
  AlignedVector<std::uint32_t> count;  ///< length of the group's longest list
  AlignedVector<std::uint32_t> list;   ///< neighbours without the particle itself; may contain pairs slightly
                                       ///< beyond the support radius
  AlignedVector<std::uint8_t> fluid;   ///< per group: 1 if cells of its neighbours contain liquid
  AlignedVector<std::uint16_t> neighbours;  ///< number of neighbours of each owned row within the support
                                            ///< radius
  std::uint32_t dummy = 0;                  ///< row of zero mass behind all other rows
  std::size_t innerGroups = 0;              ///< number of inner groups; they come first and need no ghosts
  std::size_t groups = 0;

  /// Row of neighbour n of lane l of group g, or the dummy row.
  std::uint32_t row(std::size_t g, std::size_t n, std::size_t l) const {
    return list[first[g] + 8 * n + l] / 2;
  }
};

// These functions are out of line, since code compiled for one instruction set must not emit copies of
// std::vector functions for the linker.

/// Empties the lists and reserves groups for `owned` particles in two parts.
void clearLists(NeighbourLists& lists, std::uint32_t owned, std::uint32_t dummy);
/// Makes room for at least n entries in list.
void growList(NeighbourLists& lists, std::size_t n);

}  // namespace thaw
