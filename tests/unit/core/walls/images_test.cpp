// SPDX-License-Identifier: Apache-2.0
// Images of obstacles across periodic sides.
#include <gtest/gtest.h>

#include "core/walls/walls.hpp"

namespace thaw {
namespace {

Domain box(std::initializer_list<int> periodicAxes) {
  Domain d;
  d.min = {0, 0, 0};
  d.max = {1, 2, 4};
  for (const int a : periodicAxes) d.side[static_cast<std::size_t>(a)] = {Side::Periodic, Side::Periodic};
  return d;
}

Walls oneWall(const Shape& shape, const std::vector<Keyframe>& motion = {}) {
  Wall wall;
  wall.shape = makeSignedDistance(shape);
  wall.bounds = wall.shape->bounds();
  wall.properties.motion = motion;
  Walls walls;
  walls.list.push_back(std::move(wall));
  return walls;
}

Shape cube(const Vec3d& middle, const Vec3d& size = {0.2, 0.2, 0.2}) {
  Shape s;
  s.size = size;
  s.move = middle;
  return s;
}

TEST(WallImages, AreAbsentFarFromPeriodicSides) {
  Walls walls = oneWall(cube({0.5, 0.05, 1}));
  addWallImages(box({0}), 0.1, walls);
  EXPECT_EQ(walls.list.size(), 1u);
}

TEST(WallImages, LieAPeriodAwayAcrossEachSideAndCorner) {
  Walls walls = oneWall(cube({0.95, 0.05, 1}));
  addWallImages(box({0, 1}), 0.1, walls);
  ASSERT_EQ(walls.list.size(), 4u);
  moveWalls(walls, 0);
  for (const Vec3d middle :
       {Vec3d{0.95, 0.05, 1}, Vec3d{-0.05, 0.05, 1}, Vec3d{0.95, 2.05, 1}, Vec3d{-0.05, 2.05, 1}}) {
    double least = 1;
    for (const Wall& wall : walls.list)
      least = std::min(least, wall.shape->distance(toRest(wall.pose, middle)));
    EXPECT_NEAR(least, -0.1, 1e-12);
  }
  for (std::size_t k = 1; k < 4; k++) EXPECT_EQ(walls.list[k].originalAt(k), 0u);
}

TEST(WallImages, FollowMotionOverSeveralPeriods) {
  Walls walls = oneWall(cube({0.5, 1, 1}), {{0, {}, {}}, {1, {2.5, 0, 0}, {0, 0, 6}}});
  addWallImages(box({0}), 0.1, walls);
  for (double t = 0; t <= 1; t += 0.125) {
    moveWalls(walls, t);
    const Vec3d middle = fromRest(walls.list[0].pose, {0.5, 1, 1});
    int around = 0;  // images whose centre is in the domain
    for (const Wall& wall : walls.list) {
      const Vec3d at = fromRest(wall.pose, {0.5, 1, 1});
      around += at.x >= 0 && at.x < 1;
      EXPECT_LT(length(wallVelocity(wall, at) - wallVelocity(walls.list[0], middle)), 1e-12);
    }
    EXPECT_EQ(around, 1) << t;
  }
}

TEST(WallImages, AreAbsentForObstaclesThatSpanTheDomain) {
  Shape plane;
  plane.kind = ShapeKind::HalfSpace;
  for (const Shape& shape : {cube({0.5, 1, 0}, {1, 2, 0.2}), cube({0.5, 1, 0}, {3, 5, 0.2}), plane}) {
    Walls walls = oneWall(shape);
    addWallImages(box({0, 1}), 0.1, walls);
    EXPECT_EQ(walls.list.size(), 1u);
    EXPECT_EQ(unevenAxes(box({0, 1}), walls.list[0], 0.1), "");
  }
}

TEST(WallImages, ReportPlanesWithAStepAtASide) {
  Shape plane;
  plane.kind = ShapeKind::HalfSpace;
  plane.point = {0, 0, 2};
  plane.normal = {0.1, 0, 1};
  EXPECT_EQ(unevenAxes(box({0, 1}), oneWall(plane).list[0], 0.1), "x");
}

}  // namespace
}  // namespace thaw
