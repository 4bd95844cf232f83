// SPDX-License-Identifier: Apache-2.0
// The global grid of cells. It is the same for every run of a scene, on any number of ranks. The edge of a
// cell is at least the support radius. A margin of one cell outside the domain contains periodic images and
// particles pressed into a wall.
#pragma once
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/math/vec3.hpp"

namespace thaw {

struct CellGrid {
  Vec3d origin{};  ///< m, low corner of cell (0, 0, 0)
  Vec3d edge{};    ///< m, edges of a cell; along a periodic axis an integer fraction of the domain's length
  Vec3i cells{};   ///< number of cells along each axis
  bool periodic[3]{};
  Vec3d period{};      ///< m, length of the domain along periodic axes
  double support = 0;  ///< m, support radius h
};

inline constexpr int maxCellsPerAxis = (1 << 20);

/// Returns the cell of a position. Positions outside belong to the nearest cell: walls retain particles, open
/// sides remove them. Loops should copy the grid first, so that the quotients are computed only once.
inline Vec3i cellOf(const CellGrid& g, const Vec3d& x) {
  Vec3i c;
  // Rounds towards zero: negative values are clamped to 0 anyway.
  for (int a = 0; a < 3; a++)
    c[a] = std::clamp(static_cast<int>((x[a] - g.origin[a]) * (1 / g.edge[a])), 0, g.cells[a] - 1);
  return c;
}
/// Key of a cell: z, y, x in 21 bits each, so keys ascend along x first. An offset of one allows images at
/// index -1.
inline std::uint64_t cellKey(const Vec3i& c) {
  return static_cast<std::uint64_t>(c.z + 1) << 42 | static_cast<std::uint64_t>(c.y + 1) << 21 |
         static_cast<std::uint64_t>(c.x + 1);
}
inline Vec3i cellOfKey(std::uint64_t key) {
  const int mask = (1 << 21) - 1;
  return {static_cast<int>(key & mask) - 1, static_cast<int>(key >> 21 & mask) - 1,
          static_cast<int>(key >> 42) - 1};
}
/// Key of no cell. During a migration it marks a row that is about to be dropped.
inline constexpr std::uint64_t noCell = ~std::uint64_t{0};

/// Positions in pair sums: 32-bit fixed point, 2^24 units per support radius, modulo 2^32. Differences of
/// neighbours are exact, antisymmetric and independent of the location.
inline constexpr double fixedUnitsPerSupport = 16777216.0;
/// 1.5 * 2^52. Added to a number of magnitude below 2^51, it puts the nearest integer into the low bits of
/// the mantissa.
inline constexpr double fixedPointMagic = 6755399441055744.0;
inline std::uint32_t fixedPoint(const CellGrid& g, double x, int axis) {
  return static_cast<std::uint32_t>(std::bit_cast<std::uint64_t>(
      (x - g.origin[axis]) * (fixedUnitsPerSupport / g.support) + fixedPointMagic));
}

/// Coarse position for the neighbour search: 2^14 units per support radius, modulo 2^16.
inline std::uint16_t coarsePosition(std::uint32_t fixed) { return static_cast<std::uint16_t>(fixed >> 10); }

/// Occupied cells, ascending by key. Cell c has particles [first[c], first[c] + count[c]).
struct CellTable {
  std::vector<std::uint64_t> key;
  std::vector<std::uint32_t> first, count;
  std::size_t ownedCells = 0;  ///< number of owned cells; they are not the first ones, since owned and ghost
                               ///< cells are merged by key
};

}  // namespace thaw
