// SPDX-License-Identifier: Apache-2.0
// Rows sorted by fine bins. One cell of the grid may hold hundreds of surfels.
#pragma once
#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "core/math/vec3.hpp"
#include "core/neighbours/grid.hpp"

namespace thaw {

/// Pairs of sort key and row.
using SortedRows = std::vector<std::pair<std::uint64_t, std::uint32_t>>;
/// Sorts by key with a stable radix sort, for keys below 2^bits. `other` is a buffer.
void sortByKey(SortedRows& rows, SortedRows& other, int bits);

/// Rows (ghosts included) sorted by bin, and within a bin by (cell, id) as in the grid. The order depends on
/// positions only. Sums over rows in this order therefore have the same bits on any number of ranks. Only
/// occupied bins, and occupied lines of bins along x, are listed, so empty space has no cost.
struct Bins {
  Vec3d base{};                         ///< m, low corner of bin (0, 0, 0)
  double perLength = 1;                 ///< 1/m
  std::vector<std::uint64_t> key;       ///< keys of occupied bins, ascending along x first
  std::vector<std::uint32_t> first;     ///< rows of bin b: row[first[b]] ... row[first[b + 1] - 1]
  std::vector<std::uint64_t> line;      ///< keys of occupied lines: bin keys without x
  std::vector<std::uint32_t> firstBin;  ///< bins of line l: firstBin[l] ... firstBin[l + 1] - 1
  std::vector<std::uint32_t> row;
  std::vector<Vec3d> at;       ///< m, positions of the rows when the bins were filled
  std::vector<float> x, y, z;  ///< m, positions relative to the base, rounded, for RowBlock; nearBoxMore
                               ///< longer
  SortedRows sorting, sorted;
  std::size_t size() const { return key.size(); }
};

inline constexpr double binsPerAxis = 2097151;
inline std::uint64_t binKey(std::uint64_t x, std::uint64_t y, std::uint64_t z) {
  return z << 42 | y << 21 | x;
}
inline std::uint64_t binOf(const Bins& b, double x, int axis) {
  return static_cast<std::uint64_t>(std::clamp((x - b.base[axis]) * b.perLength, 0.0, binsPerAxis));
}

/// Fills bins with an edge of about `edge` (m) with all rows listed in `cells`.
void fillBins(const CellGrid& grid, const CellTable& cells, const Vec3d* position, double edge, Bins& bins);

/// Fills bins with n positions (m); rows of a bin ascend. Use it for searches whose result does not depend on
/// the order of rows (nearest row, connected rows), or is sorted.
void fillBins(const Vec3d* position, std::size_t n, double edge, Bins& bins);

/// Copies the bins, with only the rows for which keep[row] is set, in the same order.
void pickRows(const Bins& bins, const std::uint8_t* keep, Bins& picked);

/// Calls found(from, to) for runs of occupied bins [from, to) that a box may intersect, in the order of the
/// bins. The box is [low, high], grown by `radius` (m) and rounded.
template<class Found>
void forBinRunsAround(const Bins& b, const Vec3d& low, const Vec3d& high, double radius, Found found) {
  const double r2 = (1 + 1e-9) * radius * radius, edge = 1 / b.perLength;
  const std::uint64_t y0 = binOf(b, low.y - radius, 1), y1 = binOf(b, high.y + radius, 1),
                      z0 = binOf(b, low.z - radius, 2), z1 = binOf(b, high.z + radius, 2);
  // distance from the box to a layer of bins
  const auto gap = [&](std::uint64_t bin, int axis) {
    const double from = b.base[axis] + edge * static_cast<double>(bin);
    return std::max({0.0, from - high[axis], low[axis] - (from + edge)}) * (1 - 1e-9);
  };
  const std::size_t lines = b.line.size();
  std::size_t l = 0;
  for (std::uint64_t z = z0; z <= z1; z++) {
    const std::uint64_t firstLine = z << 21 | y0, lastLine = z << 21 | y1;
    if (z == z0) {
      l = static_cast<std::size_t>(std::lower_bound(b.line.begin(), b.line.end(), firstLine) -
                                   b.line.begin());
    } else {
      // Exponential search: the next layer is usually close.
      std::size_t stride = 1;
      while (l + stride < lines && b.line[l + stride] < firstLine) l += stride, stride *= 2;
      l = static_cast<std::size_t>(
          std::lower_bound(b.line.begin() + static_cast<std::ptrdiff_t>(l),
                           b.line.begin() + static_cast<std::ptrdiff_t>(std::min(lines, l + stride + 1)),
                           firstLine) -
          b.line.begin());
    }
    if (l == lines) return;
    const double offZ = gap(z, 2);
    for (; l < lines && b.line[l] <= lastLine; l++) {
      const double offY = gap(b.line[l] & 0x1fffff, 1), left = r2 - offZ * offZ - offY * offY;
      if (left < 0) continue;
      const double reach = std::sqrt(left);
      const std::uint64_t first = b.line[l] << 21 | binOf(b, low.x - reach, 0),
                          last = b.line[l] << 21 | binOf(b, high.x + reach, 0);
      const std::size_t end = b.firstBin[l + 1];
      std::size_t k = b.firstBin[l];
      if (end - k > 8)
        k = static_cast<std::size_t>(std::lower_bound(b.key.begin() + static_cast<std::ptrdiff_t>(k),
                                                      b.key.begin() + static_cast<std::ptrdiff_t>(end),
                                                      first) -
                                     b.key.begin());
      else
        while (k < end && b.key[k] < first) k++;
      const std::size_t from = k;
      while (k < end && b.key[k] <= last) k++;
      if (k > from) found(from, k);
    }
  }
}

/// Calls found(bin) for each occupied bin that the grown box may intersect.
template<class Found>
void forBinsAround(const Bins& b, const Vec3d& low, const Vec3d& high, double radius, Found found) {
  forBinRunsAround(b, low, high, radius, [&](std::size_t from, std::size_t to) {
    for (; from < to; from++) found(from);
  });
}

/// Calls found(row, position) for all rows within `radius` (m) of the box [low, high], and for some farther
/// ones, in the order of the bins.
template<class Found>
void forRowsAround(const Bins& b, const Vec3d& low, const Vec3d& high, double radius, Found found) {
  forBinRunsAround(b, low, high, radius, [&](std::size_t from, std::size_t to) {
    for (std::uint32_t k = b.first[from]; k < b.first[to]; k++) found(b.row[k], b.at[k]);
  });
}

/// Bounding box (m) of positions.
struct PlaceBox {
  Vec3d low, high;
  void add(const Vec3d& x) {
    for (int a = 0; a < 3; a++) low[a] = std::min(low[a], x[a]), high[a] = std::max(high[a], x[a]);
  }
  double longest() const { return std::max({high.x - low.x, high.y - low.y, high.z - low.z}); }
  double distance2(const Vec3d& x) const {
    const Vec3d d{std::max({low.x - x.x, 0.0, x.x - high.x}), std::max({low.y - x.y, 0.0, x.y - high.y}),
                  std::max({low.z - x.z, 0.0, x.z - high.z})};
    return dot(d, d);
  }
};

/// Returns the bounding box of the rows of a bin.
inline PlaceBox boxOf(const Bins& b, std::size_t bin) {
  PlaceBox box{b.at[b.first[bin]], b.at[b.first[bin]]};
  for (std::uint32_t k = b.first[bin] + 1; k < b.first[bin + 1]; k++) box.add(b.at[k]);
  return box;
}

/// Rows around a box, found once for many queries: row[k] at the position at[k], for k < count.
struct RowBlock {
  std::size_t count = 0;
  // Buffers keep the size of the largest block.
  std::vector<std::uint32_t> row;
  std::vector<Vec3d> at;
  std::vector<float> x, y, z;  // m, positions relative to the bins' base, rounded
  /// Finds all rows within `radius` (m) of a box, and some a rounding error farther, in the order of the
  /// bins.
  void find(const Bins& bins, const PlaceBox& box, double radius);
  /// Returns the indices k of all rows of the block within `radius` (m) of a position, and of some a rounding
  /// error farther. They ascend and are valid until the next call.
  std::span<const std::uint32_t> around(const Vec3d& place, double radius);

 private:
  Vec3d base_{};
  std::vector<std::uint32_t> picked_;
};

/// Calls found(row, squared distance) for all rows within `radius` (m) of x. A row at x is included.
template<class Found> void forRowsWithin(const Bins& b, const Vec3d& x, double radius, Found found) {
  const double r2 = radius * radius;
  forRowsAround(b, x, x, radius, [&](std::uint32_t row, const Vec3d& at) {
    const Vec3d d = at - x;
    const double d2 = dot(d, d);
    if (d2 <= r2) found(row, d2);
  });
}

/// Calls found(row, block) for every row of `of`. The block, found once for each bin, holds at least all
/// rows of `among` within `radius` (m) of the row.
template<class Found>
void forBlocks(const Bins& of, const Bins& among, double radius, RowBlock& block, Found found) {
  for (std::size_t bin = 0; bin < of.size(); bin++) {
    block.find(among, boxOf(of, bin), radius);
    for (std::uint32_t k = of.first[bin]; k < of.first[bin + 1]; k++) found(of.row[k], block);
  }
}

}  // namespace thaw
