// SPDX-License-Identifier: Apache-2.0
#include "core/surface/search/multi_label_bins.hpp"

#include <gtest/gtest.h>

#include "core/math/hash_random.hpp"

namespace thaw {
namespace {

TEST(MultiLabelBins, HoldAllWithAnotherLabelInReach) {
  for (const int labels : {1, 2, 5}) {
    std::vector<Vec3d> x;
    std::vector<std::uint64_t> label;
    for (std::uint64_t k = 0; k < 3000; k++) {
      x.push_back({20 * randomUniform(1, Purpose::Test, k, 0), 10 * randomUniform(1, Purpose::Test, k, 1),
                   3 * randomUniform(1, Purpose::Test, k, 2)});
      label.push_back(7 + static_cast<std::uint64_t>(labels * x.back().x / 20));  // slabs
    }
    Bins bins;
    fillBins(x.data(), x.size(), 0.7, bins);
    const double reach = 0.9;
    const std::vector<std::uint8_t> mixed = multiLabelBins(bins, label.data(), bins, label.data(), reach);
    std::vector<std::uint8_t> named(x.size(), 0);
    forMultiLabel(bins, mixed, [&](std::uint32_t i) { named[i] = 1; });
    std::size_t needed = 0, all = 0;
    for (std::size_t i = 0; i < x.size(); i++) {
      bool other = false;
      for (std::size_t j = 0; j < x.size(); j++)
        other |= label[j] != label[i] && dot(x[j] - x[i], x[j] - x[i]) <= reach * reach;
      EXPECT_TRUE(named[i] || !other);
      needed += other;
      all += named[i];
    }
    if (labels == 1) EXPECT_EQ(all, 0u);
    else EXPECT_GT(needed, 100u);
    EXPECT_LT(all, 5 * needed + 1);  // and few others
  }
}

}  // namespace
}  // namespace thaw
