// SPDX-License-Identifier: Apache-2.0
#include "core/surface/search/gap_cutoffs.hpp"

#include <algorithm>
#include <limits>

#include "core/surface/search/near_sheets.hpp"

namespace thaw {

namespace {

/// Bounds of positions (m) and normals of a bin's surfels.
struct BinFrame {
  PlaceBox place, normal;
  double largest = 0;  // radius, m
};

std::vector<BinFrame> framesOf(const Surfels& f, const Bins& bins) {
  std::vector<BinFrame> frames(bins.size());
  for (std::size_t b = 0; b < bins.size(); b++) {
    const Vec3d n = f.normal[bins.row[bins.first[b]]];
    BinFrame& frame = frames[b] = {boxOf(bins, b), {n, n}, 0};
    for (std::uint32_t k = bins.first[b]; k < bins.first[b + 1]; k++)
      frame.normal.add(f.normal[bins.row[k]]), frame.largest = std::max(frame.largest, f.radius[bins.row[k]]);
  }
  return frames;
}

/// Returns the minimum of n . m for m in a box.
double leastDot(const Vec3d& n, const PlaceBox& m) {
  return std::min(n.x * m.low.x, n.x * m.high.x) + std::min(n.y * m.low.y, n.y * m.high.y) +
         std::min(n.z * m.low.z, n.z * m.high.z);
}
double mostDot(const Vec3d& n, const PlaceBox& m) { return -leastDot(-n, m); }

/// Returns the minimum of n . m for n and m, each in a box.
double leastDot(const PlaceBox& n, const PlaceBox& m) {
  double sum = 0;
  for (int a = 0; a < 3; a++)
    sum += std::min({n.low[a] * m.low[a], n.low[a] * m.high[a], n.high[a] * m.low[a], n.high[a] * m.high[a]});
  return sum;
}

/// Returns the maximum of n . d for n and d, each in a box.
double mostDot(const PlaceBox& n, const PlaceBox& d) {
  double sum = 0;
  for (int a = 0; a < 3; a++)
    sum += std::max({n.low[a] * d.low[a], n.low[a] * d.high[a], n.high[a] * d.low[a], n.high[a] * d.high[a]});
  return sum;
}

}  // namespace

// Few surfels face another one. Bins whose normals cannot differ by the angle of twoSheets are excluded
// first.
void findGapCutoffs(Surface& s, const std::vector<std::uint8_t>& free, const Bins& bins, double reach,
                    bool again) {
  Surfels& f = s.surfels;
  constexpr float none = std::numeric_limits<float>::infinity();
  const double rounding = 1e-9;
  std::vector<std::uint32_t> queries;
  std::vector<std::size_t> facingBins;
  const std::vector<BinFrame> frames = framesOf(f, bins);
  for (std::size_t b = 0; b < bins.size(); b++) {
    queries.clear();
    for (std::uint32_t k = bins.first[b]; k < bins.first[b + 1]; k++) {
      const std::uint32_t i = bins.row[k];
      if (i >= f.owned || (again && (!free[i] || f.gapCutoff[i] == none))) continue;
      f.gapCutoff[i] = none;
      if (free[i]) queries.push_back(i);
    }
    if (queries.empty()) continue;
    const BinFrame& own = frames[b];
    facingBins.clear();
    forBinsAround(bins, own.place.low, own.place.high, reach, [&](std::size_t other) {
      // Surfels behind the whole bin are across a sheet, not across a gap.
      const BinFrame& o = frames[other];
      if (leastDot(own.normal, o.normal) < twoSheets + rounding &&
          mostDot(own.normal, {o.place.low - own.place.high, o.place.high - own.place.low}) > 0)
        facingBins.push_back(other);
    });
    for (const std::uint32_t i : queries) {
      const Vec3d x = f.position[i], n = f.normal[i];
      double lowest = std::numeric_limits<double>::infinity();
      for (const std::size_t other : facingBins) {
        const BinFrame& o = frames[other];
        if (leastDot(n, o.normal) > twoSheets + rounding || o.place.distance2(x) > reach * reach) continue;
        const double under = leastDot(n, o.place) - dot(x, n), over = mostDot(n, o.place) - dot(x, n);
        if (over <= 0 || under >= lowest) continue;
        const Vec3d middle = 0.5 * (o.place.low + o.place.high) - x,
                    half = 0.5 * (o.place.high - o.place.low);
        const double along = dot(middle, n), far = length(half) + o.largest;
        // not directly above the surfel
        if (dot(middle, middle) - along * along > far * far * (1 + rounding)) continue;
        for (std::uint32_t k = bins.first[other]; k < bins.first[other + 1]; k++) {
          const std::uint32_t j = bins.row[k];
          const Vec3d d = f.position[j] - x;
          const double height = dot(d, n), r2 = dot(d, d);
          if (height >= lowest || r2 > reach * reach || r2 - height * height > f.radius[j] * f.radius[j])
            continue;
          if (f.component[j] == f.component[i] && facing(d, n, f.normal[j]) == Facing::AcrossGap)
            lowest = height;
        }
      }
      if (lowest < reach) f.gapCutoff[i] = static_cast<float>(std::max(lowest, leastGapCutoff * s.spacing));
    }
  }
}

void packGapCutoffs(const Surface& s, const GroupLists& lists, GapCutoffs& c) {
  const Surfels& f = s.surfels;
  c.any = false;
  c.height.resize(f.size());
  for (std::size_t i = 0; i < f.owned; i++) c.height[i] = f.gapCutoff[i] / static_cast<float>(s.grid.support);
  c.ofGroup.assign(lists.groups(), 0);
  for (std::size_t g = 0; g < lists.groups(); g++)
    for (std::size_t lane = 0; lane < static_cast<std::size_t>(lists.lanes[g]); lane++)
      if (c.height[lists.self[8 * g + lane]] < std::numeric_limits<float>::infinity())
        c.ofGroup[g] = 1, c.any = true;
}

}  // namespace thaw
