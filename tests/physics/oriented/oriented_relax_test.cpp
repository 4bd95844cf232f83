// SPDX-License-Identifier: Apache-2.0
// Relaxation before the start ends for any given points.
#include <gtest/gtest.h>

#include <cmath>

#include "core/math/hash_random.hpp"
#include "tests/support/oriented_samples.hpp"

namespace thaw {
namespace {

/// Points of a ball of 0.2 m, a share of whose normals point inward, for a surface to grow through.
Scene pointsOfABall(int count, double inward) {
  Scene s = test::patchScene(0);
  OrientedBody& b = s.oriented[0];
  b.source = OrientedSource::Points;
  b.growth = OrientedGrowth::Borders;
  b.removalDistance = 0.6;
  b.attract = 0.1;
  b.circle = 1.5;
  b.relax = 10000000;
  for (int k = 0; k < count; k++) {
    const double z = 1 - 2 * (k + 0.5) / count, r = std::sqrt(1 - z * z), a = 2.399963229728653 * k;
    const Vec3d n{r * std::cos(a), r * std::sin(a), z};
    b.points.push_back(0.2 * n);
    b.normals.push_back(randomUniform(3, Purpose::Test, static_cast<std::uint64_t>(k)) < inward ? -n : n);
  }
  return s;
}

// A third of the normals are reversed, so that particles appear and disappear without end.
TEST(OrientedRelaxation, EndsWherePointsSuggestNoSurface) {
  test::Simulation x(pointsOfABall(100, 0.33));
  const OrientedWork& o = x.tools.oriented;
  EXPECT_TRUE(o.relaxStalled);
  EXPECT_FALSE(o.atRest);
  EXPECT_GT(o.residualForce, 1e-9);
  EXPECT_EQ(o.relaxing, static_cast<std::int64_t>(x.w.oriented.rows.owned));
  EXPECT_EQ(o.relaxed - o.relaxProgress.gained, relaxStallLimit(o.relaxProgress.most));
  EXPECT_LT(o.relaxed, 10 * relaxStallLimit(o.relaxProgress.most));
}

TEST(OrientedRelaxation, RunsToRestForConsistentPoints) {
  test::Simulation x(pointsOfABall(100, 0));
  EXPECT_TRUE(x.tools.oriented.atRest);
  EXPECT_FALSE(x.tools.oriented.relaxStalled);
}

}  // namespace
}  // namespace thaw
