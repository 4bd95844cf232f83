#include "core/sheet/near_boxes.hpp"

namespace thaw {

namespace { constexpr double most = 1 << 20; }  // bins along an axis: a key has room for twice as many

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
    for (int a = 0; a < 3; a++) bin[a] = static_cast<int>(std::clamp(middle[a], -1.0, 1.0 + most));  // what is further off overlaps with nothing of the list that the bins are for
    b.room.push_back({cellKey(bin), k});
  }
  std::sort(b.room.begin(), b.room.end());
  b.bins = {};
  b.box.clear();
  b.number.clear();
  for (const auto& [key, k] : b.room) {
    if (b.bins.key.empty() || b.bins.key.back() != key) {
      b.bins.key.push_back(key);
      b.bins.first.push_back(static_cast<std::uint32_t>(b.box.size()));
      b.bins.count.push_back(0);
    }
    b.bins.count.back()++;
    b.box.push_back(boxes[k]);
    b.number.push_back(k);
  }
}

}  // namespace thaw
