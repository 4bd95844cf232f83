// SPDX-License-Identifier: Apache-2.0
#include "core/scene/factor_in_time.hpp"

#include <gtest/gtest.h>

namespace thaw {
namespace {

TEST(FactorInTime, MeanEqualsThatOfManySamples) {
  const FactorInTime f{{{0.1, 0.5}, {0.2, 2}, {0.25, -1}, {0.6, 0}}};
  for (const auto& [from, to] : std::vector<std::pair<double, double>>{
           {0, 1}, {0, 0.05}, {0.12, 0.18}, {0.15, 0.7}, {0.2, 0.25}, {0.65, 3}}) {
    const int n = 200000;
    double sum = 0;
    for (int k = 0; k < n; k++) sum += f.at(from + (to - from) * (k + 0.5) / n);
    EXPECT_NEAR(f.mean(from, to), sum / n, 1e-9) << from << " to " << to;
  }
  // additive over intervals
  EXPECT_NEAR(0.13 * f.mean(0, 0.13) + 0.57 * f.mean(0.13, 0.7), 0.7 * f.mean(0, 0.7), 1e-15);
}

TEST(FactorInTime, MeanOfAConstantIsExact) {
  EXPECT_EQ(FactorInTime{}.mean(0.1, 0.3), 1);
  const FactorInTime f{{{0.1, 0.3}, {0.7, 0.3}}};
  for (double from = 0; from < 1; from += 0.0731) EXPECT_EQ(f.mean(from, from + 0.011), 0.3);
}

TEST(FactorInTime, IsLinearBetweenCorners) {
  const FactorInTime f{{{0.1, 0.5}, {0.2, 2}}};
  EXPECT_TRUE(f.linear(0, 0.1));
  EXPECT_TRUE(f.linear(0.1, 0.2));
  EXPECT_FALSE(f.linear(0.19, 0.21));
}

}  // namespace
}  // namespace thaw
