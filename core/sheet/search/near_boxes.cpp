// SPDX-License-Identifier: Apache-2.0
#include "core/sheet/search/near_boxes.hpp"

#include <cmath>

namespace thaw {

namespace {
constexpr double most = 1 << 20;
}  // namespace

BoxBins binsFor(const std::vector<Box>& boxes) {
  if (boxes.empty()) return {{}, 1};
  Box all = boxes[0];
  double largest = 0;
  for (const Box& x : boxes) {
    all.take(x.low);
    all.take(x.high);
    for (int k = 0; k < 3; k++) largest = std::max(largest, x.high[k] - x.low[k]);
  }
  for (int k = 0; k < 3; k++) largest = std::max(largest, (all.high[k] - all.low[k]) / most);
  return {all.low, largest > 0 ? largest : 1};
}

void binBoxes(const std::vector<Box>& boxes, const BoxBins& bins, BinnedBoxes& b) {
  b.room.clear();
  for (std::uint32_t k = 0; k < boxes.size(); k++) {
    const Vec3d middle = (1 / bins.edge) * (0.5 * (boxes[k].low + boxes[k].high) - bins.origin);
    Vec3i bin;
    // boxes farther away overlap no box of the list that defines the bins
    for (int a = 0; a < 3; a++) bin[a] = static_cast<int>(std::clamp(middle[a], -1.0, 1.0 + most));
    b.room.push_back({cellKey(bin), k});
  }
  std::sort(b.room.begin(), b.room.end());
  b.bins = {};
  for (int a = 0; a < 3; a++) {
    b.low[a].clear();
    b.high[a].clear();
  }
  b.number.clear();
  for (const auto& [key, k] : b.room) {
    if (b.bins.key.empty() || b.bins.key.back() != key) {
      b.bins.key.push_back(key);
      b.bins.first.push_back(static_cast<std::uint32_t>(b.number.size()));
      b.bins.count.push_back(0);
    }
    b.bins.count.back()++;
    for (int a = 0; a < 3; a++) {
      b.low[a].push_back(std::nextafter(static_cast<float>(boxes[k].low[a]), -HUGE_VALF));
      b.high[a].push_back(std::nextafter(static_cast<float>(boxes[k].high[a]), HUGE_VALF));
    }
    b.number.push_back(k);
  }
}

void overlaps(const BinnedBoxes& a, std::uint32_t i, const BinnedBoxes& b, const RowSpan& rows,
              std::int32_t* hit) {
  const float x0 = a.low[0][i], x1 = a.high[0][i], y0 = a.low[1][i], y1 = a.high[1][i], z0 = a.low[2][i],
              z1 = a.high[2][i];
  const float *lx = b.low[0].data() + rows.begin, *ly = b.low[1].data() + rows.begin,
              *lz = b.low[2].data() + rows.begin;
  const float *hx = b.high[0].data() + rows.begin, *hy = b.high[1].data() + rows.begin,
              *hz = b.high[2].data() + rows.begin;
  const std::uint32_t n = rows.end - rows.begin;
  for (std::uint32_t k = 0; k < n; k++)
    hit[k] = (lx[k] <= x1) & (hx[k] >= x0) & (ly[k] <= y1) & (hy[k] >= y0) & (lz[k] <= z1) & (hz[k] >= z0);
}

}  // namespace thaw
