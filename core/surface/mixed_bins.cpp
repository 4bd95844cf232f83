#include "core/surface/mixed_bins.hpp"

namespace thaw {
namespace {

struct Range { std::uint64_t least = ~std::uint64_t{0}, most = 0; };

std::vector<Range> rangesOf(const Bins& bins, const std::uint64_t* label) {
  std::vector<Range> ranges(bins.size());
  for (std::size_t b = 0; b < bins.size(); b++)
    for (std::uint32_t k = bins.first[b]; k < bins.first[b + 1]; k++) {
      const std::uint64_t l = label[bins.row[k]];
      ranges[b] = {std::min(ranges[b].least, l), std::max(ranges[b].most, l)};
    }
  return ranges;
}

}  // namespace

std::vector<std::uint8_t> mixedBins(const Bins& of, const std::uint64_t* ofLabel, const Bins& among, const std::uint64_t* label, double reach) {
  const std::vector<Range> own = rangesOf(of, ofLabel), others = rangesOf(among, label);
  Range all;
  for (const std::vector<Range>* ranges : {&own, &others})
    for (const Range& r : *ranges) all = {std::min(all.least, r.least), std::max(all.most, r.most)};
  std::vector<std::uint8_t> mixed(of.size(), 0);
  for (std::size_t b = 0; b < of.size() && all.least < all.most; b++) {
    Range here = own[b];
    const PlaceBox box = boxOf(of, b);
    forBinsAround(among, box.low, box.high, reach, [&](std::size_t other) { here = {std::min(here.least, others[other].least), std::max(here.most, others[other].most)}; });
    mixed[b] = here.least < here.most;
  }
  return mixed;
}

}  // namespace thaw
