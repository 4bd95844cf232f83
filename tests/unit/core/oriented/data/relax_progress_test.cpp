// SPDX-License-Identifier: Apache-2.0
// Conditions that end a relaxation without rest.
#include "core/oriented/data/relax_progress.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace thaw {
namespace {

/// Iteration at which a relaxation with these figures ends; -1 if it does not end within `most`.
template<class Force, class Particles>
std::int64_t endOf(std::int64_t most, const Force& force, const Particles& particles) {
  RelaxProgress p;
  for (std::int64_t k = 0; k < most; k++)
    if (!makesProgress(p, k, force(k), particles(k))) return k;
  return -1;
}

TEST(RelaxProgress, EndsWithoutImprovement) {
  const auto always = [](std::int64_t n) { return [n](std::int64_t) { return n; }; };
  EXPECT_LT(endOf(
                100000, [](std::int64_t k) { return 2 + std::sin(static_cast<double>(k)); }, always(900)),
            2 * relaxStallLimit(900));
  EXPECT_EQ(endOf(
                100000, [](std::int64_t) { return 1.0; }, always(900)),
            relaxStallLimit(900));
  // births balance deaths: no growth
  EXPECT_LT(endOf(
                100000, [](std::int64_t) { return 1.0; }, [](std::int64_t k) { return 1000 + k % 15; }),
            2 * relaxStallLimit(1000));
}

TEST(RelaxProgress, ContinuesWithImprovement) {
  EXPECT_EQ(endOf(
                100000, [](std::int64_t k) { return std::exp(-2e-4 * static_cast<double>(k)); },
                [](std::int64_t) { return 900; }),
            -1);
  EXPECT_EQ(endOf(
                100000, [](std::int64_t) { return 1.0; }, [](std::int64_t k) { return 1000 + k / 10; }),
            -1);
  // at rest with few particles, before others are added
  EXPECT_EQ(
      endOf(
          3000, [](std::int64_t k) { return k < 10 ? 0.0 : 1e3 * std::exp(-1e-3 * static_cast<double>(k)); },
          [](std::int64_t k) { return k < 10 ? 100 : 1000; }),
      -1);
}

TEST(RelaxProgress, BoundedProgressEnds) {
  // the slowest progress that still counts: a tenth less force, a fiftieth more particles, each at the last
  // moment
  RelaxProgress p;
  std::int64_t particles = 1000, k = 0, waited = 0;
  double force = 1;
  for (; k < 10000000; k++) {
    const bool last = ++waited >= relaxStallLimit(particles) - 1;
    if (last && particles < 3000)
      particles = static_cast<std::int64_t>(1.03 * static_cast<double>(particles)) + 1, waited = 0;
    else if (last && force > 1e-9) force *= 0.89, waited = 0;
    if (!makesProgress(p, k, force, particles)) break;
  }
  EXPECT_LT(k, 260 * relaxStallLimit(3000));
}

}  // namespace
}  // namespace thaw
