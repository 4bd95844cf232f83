// Pairs of boxes that overlap, from bins of their middles. What is found does not depend on the bins; in which order, does.
#pragma once
#include <algorithm>
#include <array>

#include "core/neighbours/grid.hpp"
#include "core/sheet/rows_around.hpp"

namespace thaw {

struct Box {
  Vec3d low, high;
  void take(const Vec3d& x) {
    for (int a = 0; a < 3; a++) {
      low[a] = std::min(low[a], x[a]);
      high[a] = std::max(high[a], x[a]);
    }
  }
  bool meets(const Box& b) const {
    return low.x <= b.high.x && b.low.x <= high.x && low.y <= b.high.y && b.low.y <= high.y && low.z <= b.high.z && b.low.z <= high.z;
  }
};

/// Around all corners, and further by a margin (m).
template<std::size_t n> Box boxAround(const std::array<Vec3d, n>& corners, double margin) {
  Box b{corners[0], corners[0]};
  for (const Vec3d& x : corners) b.take(x);
  for (int a = 0; a < 3; a++) b.low[a] -= margin, b.high[a] += margin;
  return b;
}

/// Boxes sorted by the bin of their middles.
struct BinnedBoxes {
  CellTable bins;
  std::vector<Box> box;
  std::vector<std::uint32_t> number;  ///< of each, in the list that was given
  std::vector<std::pair<std::uint64_t, std::uint32_t>> room;
};

/// Cubes of the edge of the largest box, from the lowest corner: boxes that overlap, of this list or no larger, are in the same or in neighbouring ones.
struct BoxBins { Vec3d origin; double edge; };
BoxBins binsFor(const std::vector<Box>& boxes);
void binBoxes(const std::vector<Box>& boxes, const BoxBins& bins, BinnedBoxes& binned);

/// Calls use(number in a, number in b) for all pairs that overlap.
template<class Use> void eachNearPair(const BinnedBoxes& a, const BinnedBoxes& b, Use&& use) {
  std::vector<RowRange> ranges;
  for (std::size_t c = 0; c < a.bins.key.size(); c++) {
    rowsAround(b.bins, a.bins.key[c], ranges);
    for (std::uint32_t i = a.bins.first[c]; i < a.bins.first[c] + a.bins.count[c]; i++) {
      const Box own = a.box[i];
      for (const RowRange& r : ranges)
        for (std::uint32_t j = r.begin; j < r.end; j++)
          if (own.meets(b.box[j])) use(a.number[i], b.number[j]);
    }
  }
}

}  // namespace thaw
