// SPDX-License-Identifier: Apache-2.0
#include "core/math/hash_random.hpp"

#include <gtest/gtest.h>

namespace thaw {
namespace {

TEST(HashRandom, IsUniformAndIndependent) {
  double mean = 0, correlation = 0;
  const int n = 100000;
  for (int k = 0; k < n; k++) {
    const double a = randomUniform(1, Purpose::Jitter, static_cast<std::uint64_t>(k), 0),
                 b = randomUniform(1, Purpose::Jitter, static_cast<std::uint64_t>(k), 1);
    ASSERT_TRUE(a >= 0 && a < 1);
    mean += a / n;
    correlation += (a - 0.5) * (b - 0.5) * 12 / n;
  }
  EXPECT_NEAR(mean, 0.5, 0.005);
  EXPECT_NEAR(correlation, 0, 0.015);
  EXPECT_NE(randomBits(1, Purpose::Jitter, 5), randomBits(2, Purpose::Jitter, 5));
  EXPECT_NE(randomBits(1, Purpose::Jitter, 5), randomBits(1, Purpose::Emission, 5));
  EXPECT_EQ(randomBits(1, Purpose::Jitter, 5), randomBits(1, Purpose::Jitter, 5, 0));
}

}  // namespace
}  // namespace thaw
