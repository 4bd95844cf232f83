// Rows by fine bins: what finds surfels around surfels, hundreds of which may lie in one cell of the grid.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/math/vec3.hpp"
#include "core/neighbours/grid.hpp"

namespace thaw {

/// Rows (ghosts included) sorted by bin, and within a bin as they are in the grid: by (cell, id). The order depends on places alone, not on
/// which rank holds a row, so sums over rows in this order have the same bits on any number of ranks.
struct Bins {
  Vec3d base{};                    ///< m, low corner of bin (0, 0, 0)
  double perLength = 1;            ///< 1/m
  std::vector<std::uint64_t> key;  ///< of each row in the order; keys ascend along x first
  std::vector<std::uint32_t> row;
  std::vector<Vec3d> at;           ///< m, places of these rows when the bins were filled
  std::vector<std::pair<std::uint64_t, std::uint32_t>> sorting;
};

inline constexpr double binsPerAxis = 2097151;
inline std::uint64_t binKey(std::uint64_t x, std::uint64_t y, std::uint64_t z) { return z << 42 | y << 21 | x; }
inline std::uint64_t binOf(const Bins& b, double x, int axis) { return static_cast<std::uint64_t>(std::clamp(std::floor((x - b.base[axis]) * b.perLength), 0.0, binsPerAxis)); }

/// Bins of about `edge` (m) for all rows that `cells` lists.
void fillBins(const CellGrid& grid, const CellTable& cells, const Vec3d* position, double edge, Bins& bins);

/// First row from `at` on whose key is not below `wanted`: by strides that double, since the next line of bins is rarely far.
inline std::size_t firstFrom(const Bins& b, std::size_t at, std::uint64_t wanted) {
  const std::size_t n = b.key.size();
  std::size_t stride = 1, low = at;
  while (low + stride < n && b.key[low + stride] < wanted) {
    low += stride;
    stride *= 2;
  }
  const auto begin = b.key.begin();
  return static_cast<std::size_t>(std::lower_bound(begin + static_cast<std::ptrdiff_t>(low), begin + static_cast<std::ptrdiff_t>(std::min(n, low + stride + 1)), wanted) - begin);
}

/// Calls found(row) for all rows in the bins that meet the box [low, high], in the order of the bins.
template<class Found> void forRowsInBox(const Bins& b, const Vec3d& low, const Vec3d& high, Found found) {
  const std::uint64_t x0 = binOf(b, low.x, 0), x1 = binOf(b, high.x, 0), y0 = binOf(b, low.y, 1), y1 = binOf(b, high.y, 1), z0 = binOf(b, low.z, 2), z1 = binOf(b, high.z, 2);
  const std::size_t n = b.key.size();
  std::size_t at = 0;
  bool first = true;
  for (std::uint64_t z = z0; z <= z1; z++)
    for (std::uint64_t y = y0; y <= y1; y++) {
      const std::uint64_t last = binKey(x1, y, z);
      if (first) at = static_cast<std::size_t>(std::lower_bound(b.key.begin(), b.key.end(), binKey(x0, y, z)) - b.key.begin());
      else if (at < n && b.key[at] < binKey(x0, y, z)) at = firstFrom(b, at, binKey(x0, y, z));
      first = false;
      for (; at < n && b.key[at] <= last; at++) found(b.row[at]);
    }
}

/// Calls found(row, place) for all rows whose place is within `radius` (m) of the box [low, high], and some more, in the order of the bins: of each
/// line of bins along x only what a rounded box may reach.
template<class Found> void forRowsAround(const Bins& b, const Vec3d& low, const Vec3d& high, double radius, Found found) {
  const double r2 = (1 + 1e-9) * radius * radius, edge = 1 / b.perLength;
  const std::uint64_t y0 = binOf(b, low.y - radius, 1), y1 = binOf(b, high.y + radius, 1), z0 = binOf(b, low.z - radius, 2), z1 = binOf(b, high.z + radius, 2);
  const auto gap = [&](std::uint64_t bin, int axis) {  // from the box to a layer of bins
    const double from = b.base[axis] + edge * static_cast<double>(bin);
    return std::max({0.0, from - high[axis], low[axis] - (from + edge)}) * (1 - 1e-9);
  };
  const std::size_t n = b.key.size();
  std::size_t at = 0;
  bool first = true;
  for (std::uint64_t z = z0; z <= z1; z++) {
    const double offZ = gap(z, 2);
    for (std::uint64_t y = y0; y <= y1; y++) {
      const double offY = gap(y, 1), left = r2 - offZ * offZ - offY * offY;
      if (left < 0) continue;
      const double reach = std::sqrt(left);
      const std::uint64_t from = binKey(binOf(b, low.x - reach, 0), y, z), last = binKey(binOf(b, high.x + reach, 0), y, z);
      if (first) at = static_cast<std::size_t>(std::lower_bound(b.key.begin(), b.key.end(), from) - b.key.begin());
      else if (at < n && b.key[at] < from) at = firstFrom(b, at, from);
      first = false;
      for (; at < n && b.key[at] <= last; at++) found(b.row[at], b.at[at]);
    }
  }
}

}  // namespace thaw
