// SPDX-License-Identifier: Apache-2.0
#include "core/math/exact_sum.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "core/math/hash_random.hpp"

namespace thaw {
namespace {

constexpr double inf = std::numeric_limits<double>::infinity();

double exact(const std::vector<double>& terms) {
  ExactSum s;
  for (double x : terms) s.add(x);
  return s.value();
}

std::uint64_t bits(double x) { return std::bit_cast<std::uint64_t>(x); }

TEST(ExactSumOracle, KeepsSingleTerms) {
  for (double x : {0.0, 1.0, -1.0, 0.1, -1e300, 1e-300, 5e-324, -5e-324, std::numeric_limits<double>::max(),
                   std::numeric_limits<double>::min(), -std::numeric_limits<double>::max(), 4294967296.0,
                   -4294967295.0, 0x1.fffffffffffffp31})
    EXPECT_EQ(bits(exact({x})), bits(x)) << x;
  for (std::uint64_t k = 0; k < 20000; k++) {
    const double x = std::bit_cast<double>(randomBits(1, Purpose::Test, k));
    if (std::isfinite(x)) { ASSERT_EQ(bits(exact({x})), bits(x)) << x; }
  }
}

TEST(ExactSumOracle, AgreesWithWideIntegers) {
  std::mt19937_64 random(7);
  for (int trial = 0; trial < 3000; trial++) {
    __int128 sum = 0;
    std::vector<double> terms;
    const int n = 1 + static_cast<int>(random() % 40);
    for (int k = 0; k < n; k++) {
      const int shift = static_cast<int>(random() % 60);
      const std::int64_t m = static_cast<std::int64_t>(random() >> 11) * (random() & 1 ? 1 : -1);
      sum += static_cast<__int128>(m) * (static_cast<__int128>(1) << shift);
      terms.push_back(std::ldexp(static_cast<double>(m), shift - 100));
    }
    // the conversion rounds to nearest even
    ASSERT_EQ(exact(terms), std::ldexp(static_cast<double>(sum), -100));
  }
}

TEST(ExactSumOracle, StaysExactOverManyTerms) {
  ExactSum s;
  for (int k = 0; k < 2000000; k++) s.add(-0.1);
  const double head = -200000.0;
  ExactSum rest = s;
  rest.add(-head);
  // 0.1 is this integer over 2^55
  const __int128 expected = (static_cast<__int128>(200000) << 55) -
                            static_cast<__int128>(3602879701896397) * 2000000;
  EXPECT_EQ(rest.value(), std::ldexp(static_cast<double>(expected), -55));
  for (int k = 0; k < 62; k++) {  // 2^62 times as much, through many carries
    const ExactSum copy = s;
    s += copy;
  }
  EXPECT_EQ(s.value(), std::ldexp(exact({head, rest.value()}), 62));
}

TEST(ExactSumOracle, NotFiniteStaysNaN) {
  for (double bad : {inf, -inf, std::numeric_limits<double>::quiet_NaN()}) {
    ExactSum s;
    s.add(1);
    s.add(bad);
    for (int k = 0; k < 1000; k++) s.add(bad), s.add(-1e308);
    EXPECT_TRUE(std::isnan(s.value()));
    ExactSum t;
    t.add(-5);
    for (int k = 0; k < 200; k++) {
      t += s;
      const ExactSum u = t;
      t += u;
    }
    EXPECT_TRUE(std::isnan(t.value()));
  }
}

}  // namespace
}  // namespace thaw
