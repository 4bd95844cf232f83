// SPDX-License-Identifier: Apache-2.0
#include "core/math/exact_sum.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <random>
#include <vector>

using thaw::ExactSum;

namespace {

double sumOf(const std::vector<double>& v) {
  ExactSum s;
  for (const double x : v) s.add(x);
  return s.value();
}

}  // namespace

TEST(ExactSum, SingleValuesAreUnchanged) {
  for (const double x : {0.0, 1.0, -1.0, 0.1, -1e300, DBL_MAX, -DBL_MAX, DBL_MIN, 4.9406564584124654e-324,
                         -4.9406564584124654e-324, 1e-310, 3.0e-17})
    EXPECT_EQ(sumOf({x}), x);
  EXPECT_EQ(ExactSum{}.value(), 0);
}

TEST(ExactSum, SumsHaveNoRounding) {
  EXPECT_EQ(sumOf({1e300, 1, -1e300}), 1);
  EXPECT_EQ(sumOf({DBL_MAX, DBL_MAX, -DBL_MAX}), DBL_MAX);
  EXPECT_EQ(sumOf({1, 1e-300, -1}), 1e-300);
  EXPECT_EQ(sumOf({-1, std::ldexp(1, -60)}), -1 + std::ldexp(1, -60));
  EXPECT_TRUE(std::isinf(sumOf({DBL_MAX, DBL_MAX})));
}

TEST(ExactSum, RoundsOnceToNearestEven) {
  const double ulp = DBL_EPSILON;
  EXPECT_EQ(sumOf({1, ulp / 2}), 1);
  EXPECT_EQ(sumOf({1, ulp / 2, 1e-300}), 1 + ulp);
  EXPECT_EQ(sumOf({1 + ulp, ulp / 2}), 1 + 2 * ulp);
  EXPECT_EQ(sumOf({-1, -ulp / 2, -1e-300}), -1 - ulp);
}

TEST(ExactSum, OrderAndPartitionDoNotMatter) {
  std::mt19937_64 random(5);
  std::vector<double> v;
  for (int n = 0; n < 4000; n++)
    v.push_back(std::ldexp(static_cast<double>(static_cast<std::int64_t>(random())),
                           static_cast<int>(random() % 200) - 100));
  const double all = sumOf(v);
  for (int n = 0; n < 5; n++) {
    std::shuffle(v.begin(), v.end(), random);
    EXPECT_EQ(sumOf(v), all);
    ExactSum parts[3], total;
    for (std::size_t i = 0; i < v.size(); i++) parts[i * i % 3].add(v[i]);
    for (ExactSum& p : parts) total += p;
    EXPECT_EQ(total.value(), all);
    // digit by digit, as over ranks
    ExactSum digits;
    for (ExactSum& p : parts) {
      p.carry();
      for (int k = 0; k < ExactSum::digits; k++)
        digits.digit[static_cast<std::size_t>(k)] += p.digit[static_cast<std::size_t>(k)];
    }
    EXPECT_EQ(digits.value(), all);
  }
  for (const double x : std::vector<double>(v)) v.push_back(-x);
  EXPECT_EQ(sumOf(v), 0);
}

TEST(ExactSum, NonFiniteIsNotHidden) {
  EXPECT_TRUE(std::isnan(sumOf({1, NAN})));
  EXPECT_TRUE(std::isnan(sumOf({INFINITY, -5})));
  EXPECT_TRUE(std::isnan(sumOf({-INFINITY})));
}
