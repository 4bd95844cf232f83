// SPDX-License-Identifier: Apache-2.0
#include "io/text/duration_text.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace thaw {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(DurationText, HasASuitableUnit) {
  EXPECT_EQ(durationText(0.123), "0.12 s");
  EXPECT_EQ(durationText(12), "12 s");
  EXPECT_EQ(durationText(600), "10 min");
  EXPECT_EQ(durationText(9000), "2.5 h");
  EXPECT_EQ(durationText(86400.0 * 12), "12 days");
  EXPECT_EQ(durationText(86400.0 * 365.25 * 7.3), "7.3 years");
  for (const double endless : {1e150, infinity, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_EQ(durationText(endless), "more than 1000 years");
}

TEST(CountText, IsShort) {
  EXPECT_EQ(countText(0), "0");
  EXPECT_EQ(countText(123456), "123456");
  EXPECT_EQ(countText(7.84e149), "7.8e+149");
  EXPECT_EQ(countText(infinity), "infinitely many");
}

}  // namespace
}  // namespace thaw
