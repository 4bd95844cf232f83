// SPDX-License-Identifier: Apache-2.0
#include "core/surface/search/multi_label_bins.hpp"

namespace thaw {
namespace {

struct Range {
  std::uint64_t least = ~std::uint64_t{0}, most = 0;
  void add(const Range& o) { least = std::min(least, o.least), most = std::max(most, o.most); }
  bool two() const { return least < most; }
};

std::vector<Range> rangesOf(const Bins& bins, const std::uint64_t* label) {
  std::vector<Range> ranges(bins.size());
  for (std::size_t b = 0; b < bins.size(); b++)
    for (std::uint32_t k = bins.first[b]; k < bins.first[b + 1]; k++)
      ranges[b].add({label[bins.row[k]], label[bins.row[k]]});
  return ranges;
}

}  // namespace

std::vector<std::uint8_t> multiLabelBins(const Bins& of, const std::uint64_t* ofLabel, const Bins& among,
                                         const std::uint64_t* label, double reach) {
  const std::vector<Range> own = rangesOf(of, ofLabel), others = rangesOf(among, label);
  Range all;
  for (const std::vector<Range>* ranges : {&own, &others})
    for (const Range& r : *ranges) all.add(r);
  std::vector<std::uint8_t> mixed(of.size(), 0);
  if (!all.two()) return mixed;
  const auto seen = [&](const PlaceBox& box) {
    Range here;
    forBinsAround(among, box.low, box.high, reach, [&](std::size_t other) { here.add(others[other]); });
    return here;
  };
  for (std::size_t b = 0; b < of.size();) {
    // Bins of one line are consecutive. First test as many as lie within a few radii.
    PlaceBox box = boxOf(of, b);
    Range here = own[b];
    std::size_t end = b + 1;
    for (; end < of.size(); end++) {
      const PlaceBox next = boxOf(of, end);
      PlaceBox more = box;
      more.add(next.low), more.add(next.high);
      if (more.longest() > 4 * reach) break;
      box = more, here.add(own[end]);
    }
    here.add(seen(box));
    for (; b < end; b++) {
      if (!here.two()) continue;
      Range near = own[b];
      near.add(seen(boxOf(of, b)));
      mixed[b] = near.two();
    }
  }
  return mixed;
}

}  // namespace thaw
