// SPDX-License-Identifier: Apache-2.0
// Pairs of overlapping boxes, found by bins of their centres. The set of pairs does not depend on the bins,
// but the order of the pairs does.
#pragma once
#include <algorithm>
#include <array>

#include "core/neighbours/grid.hpp"
#include "core/neighbours/rows_around.hpp"

namespace thaw {

struct Box {
  Vec3d low, high;
  void take(const Vec3d& x) {
    for (int a = 0; a < 3; a++) {
      low[a] = std::min(low[a], x[a]);
      high[a] = std::max(high[a], x[a]);
    }
  }
};

/// Returns the box (m) around all corners, enlarged by a margin (m).
template<std::size_t n> Box boxAround(const std::array<Vec3d, n>& corners, double margin) {
  Box b{corners[0], corners[0]};
  for (const Vec3d& x : corners) b.take(x);
  for (int a = 0; a < 3; a++) b.low[a] -= margin, b.high[a] += margin;
  return b;
}

/// Boxes sorted by the bin of their centres. Sides have single precision, rounded outward, and are stored by
/// axis for vectorisation.
struct BinnedBoxes {
  CellTable bins;
  std::vector<float> low[3], high[3];
  std::vector<std::uint32_t> number;  ///< index of each box in the input list
  std::vector<std::pair<std::uint64_t, std::uint32_t>> room;
};

/// Cubic bins, from the lowest corner (m), with the edge (m) of the largest box. Overlapping boxes of this
/// list, or smaller boxes, lie in equal or adjacent bins.
struct BoxBins {
  Vec3d origin;
  double edge;
};
BoxBins binsFor(const std::vector<Box>& boxes);
void binBoxes(const std::vector<Box>& boxes, const BoxBins& bins, BinnedBoxes& binned);

/// Sets hit[k] if box i of a overlaps box rows.begin + k of b.
void overlaps(const BinnedBoxes& a, std::uint32_t i, const BinnedBoxes& b, const RowSpan& rows,
              std::int32_t* hit);

/// Calls use(index in a, index in b) for all pairs that overlap, and for some that nearly do.
template<class Use> void eachNearPair(const BinnedBoxes& a, const BinnedBoxes& b, Use&& use) {
  std::vector<RowSpan> ranges;
  std::vector<std::int32_t> hit;
  for (std::size_t c = 0; c < a.bins.key.size(); c++) {
    rowsAround(b.bins, a.bins.key[c], ranges);
    for (std::uint32_t i = a.bins.first[c]; i < a.bins.first[c] + a.bins.count[c]; i++) {
      for (const RowSpan& r : ranges) {
        const std::uint32_t n = r.end - r.begin;
        hit.resize(n);
        overlaps(a, i, b, r, hit.data());
        for (std::uint32_t k = 0; k < n; k++)
          if (hit[k]) use(a.number[i], b.number[r.begin + k]);
      }
    }
  }
}

}  // namespace thaw
