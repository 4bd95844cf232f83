// SPDX-License-Identifier: Apache-2.0
// Surfaces that grow at their borders toward obstacles and solids create no particles inside them, neither in
// a run nor in the relaxation before it.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/oriented_samples.hpp"

namespace thaw {
namespace {

/// A patch that grows at its borders up to 600 particles, 0.05 m away from the object of the test.
Scene growingPatch() {
  Scene s = test::emptyScene(0.02, {-0.6, -0.6, -0.3}, {0.6, 0.6, 0.6});
  s.oriented.emplace_back();
  OrientedBody& b = s.oriented.back();
  b.name = "p";
  b.source = OrientedSource::Patch;
  b.width = b.depth = 0.2;
  b.density = 20;
  b.growth = OrientedGrowth::Borders;
  b.most = 600;
  b.damping = b.spinDamping = 10;
  s.end = 0.06;
  return s;
}

void addBlock(Scene& s) {
  s.materials.emplace_back();
  s.materials[0].young = {2e5, 2e5};
  test::addBox(s, {0.15, -0.2, -0.1}, {0.35, 0.2, 0.1});
}

/// Particles of the surface inside the block, deeper than a few hundredths of a spacing.
std::int64_t inBlock(const World& w) {
  std::int64_t n = 0;
  for (std::size_t i = 0; i < w.oriented.rows.owned; i++) {
    const Vec3d x = w.oriented.rows.position[i] - Vec3d{0.25, 0, 0};
    n += std::abs(x.x) < 0.099 && std::abs(x.y) < 0.199 && std::abs(x.z) < 0.099;
  }
  return n;
}

TEST(OrientedBirthRoom, NoBirthInsideObstacles) {
  Scene s = growingPatch();
  Obstacle& wall = test::addFloor(s);
  wall.shape.point = {0.15, 0, 0};
  wall.shape.normal = {-1, 0, 0};
  test::Simulation x(s);
  ASSERT_TRUE(x.run());
  EXPECT_EQ(x.w.oriented.rows.owned, 600u) << "it grows toward the free sides";
  for (std::size_t i = 0; i < x.w.oriented.rows.owned; i++) EXPECT_LT(x.w.oriented.rows.position[i].x, 0.15);
}

TEST(OrientedBirthRoom, NoBirthInsideSolids) {
  Scene s = growingPatch();
  addBlock(s);
  test::Simulation x(s);
  ASSERT_TRUE(x.run());
  EXPECT_EQ(x.w.oriented.rows.owned, 600u);
  EXPECT_EQ(inBlock(x.w), 0);
}

// Solids beyond a periodic side count as well.
TEST(OrientedBirthRoom, NoBirthInsideSolidsAcrossPeriodicSides) {
  Scene s = growingPatch();
  addBlock(s);
  s.domain.side[0] = {Side::Periodic, Side::Periodic};
  s.domain.min.x = -0.12;
  s.domain.max.x = 0.36;
  s.end = 0.02;
  test::Simulation x(s);
  ASSERT_TRUE(x.run());
  EXPECT_EQ(inBlock(x.w), 0);
}

TEST(OrientedBirthRoom, NoBirthInsideSolidsBeforeTheStart) {
  Scene s = growingPatch();
  addBlock(s);
  test::addFloor(s).shape = test::boxOf({-0.3, -0.4, -0.2}, {-0.15, 0.4, 0.2});
  s.oriented[0].relax = 400;
  test::Simulation x(s);
  EXPECT_GT(x.w.oriented.rows.owned, 400u);
  EXPECT_EQ(inBlock(x.w), 0);
  for (std::size_t i = 0; i < x.w.oriented.rows.owned; i++) {
    const Vec3d p = x.w.oriented.rows.position[i];
    EXPECT_FALSE(p.x > -0.3 && p.x < -0.15 && std::abs(p.y) < 0.4);
  }
}

}  // namespace
}  // namespace thaw
