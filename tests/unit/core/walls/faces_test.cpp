// SPDX-License-Identifier: Apache-2.0
// Faces of walls near a point, in corners, gaps and on curved surfaces.
#include "core/walls/faces.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/geometry/shapes/combined.hpp"
#include "core/geometry/shapes/primitives.hpp"

namespace thaw::test {
namespace {

constexpr double h = 0.2, dx = 0.1;

/// A block with a box cut out of it, open at the top. The inner sides are at x = -1 and 1, y = -0.5 and 0.5,
/// z = 0.
CombinedDistance tank() {
  const auto block = std::make_shared<BoxDistance>(Vec3d{4, 3, 2});
  const auto hole = std::make_shared<PlacedDistance>(std::make_shared<BoxDistance>(Vec3d{2, 1, 4}),
                                                     Placement{1, identity3<double>(), {0, 0, 2}});
  return CombinedDistance(CombinedDistance::Kind::Difference, {block, hole});
}

void expectFace(const Face& f, double distance, const Vec3d& normal) {
  EXPECT_NEAR(f.distance, distance, 1e-12);
  EXPECT_NEAR(length(f.normal - normal), 0, 1e-12);
}

TEST(Faces, AFlatPartOfAWallHasOne) {
  const Faces f = facesWithin(tank(), {0, 0, 0.07}, h, dx);
  ASSERT_EQ(f.count, 1U);
  expectFace(f.face[0], 0.07, {0, 0, 1});
}

TEST(Faces, AnInnerEdgeHasTwoTheNearestFirst) {
  const Faces f = facesWithin(tank(), {-0.95, 0, 0.07}, h, dx);
  ASSERT_EQ(f.count, 2U);
  expectFace(f.face[0], 0.05, {1, 0, 0});
  expectFace(f.face[1], 0.07, {0, 0, 1});
}

TEST(Faces, AnInnerCornerHasThree) {
  const Faces f = facesWithin(tank(), {-0.95, 0.41, 0.07}, h, dx);
  ASSERT_EQ(f.count, 3U);
  expectFace(f.face[0], 0.05, {1, 0, 0});
  EXPECT_NEAR(f.face[1].distance + f.face[2].distance, 0.09 + 0.07, 1e-12);
}

TEST(Faces, PointInsideTheWallHasBoth) {
  const Faces f = facesWithin(tank(), {-0.95, 0, -0.02}, h, dx);
  ASSERT_EQ(f.count, 2U);
  expectFace(f.face[0], -0.02, {0, 0, 1});
  expectFace(f.face[1], 0.05, {1, 0, 0});
}

TEST(Faces, AGapHasBothSides) {
  const auto a = std::make_shared<PlacedDistance>(std::make_shared<BoxDistance>(Vec3d{1, 1, 1}),
                                                  Placement{1, identity3<double>(), {-0.55, 0, 0}});
  const auto b = std::make_shared<PlacedDistance>(std::make_shared<BoxDistance>(Vec3d{1, 1, 1}),
                                                  Placement{1, identity3<double>(), {0.6, 0, 0}});
  const Faces f = facesWithin(CombinedDistance(CombinedDistance::Kind::Union, {a, b}), {0, 0, 0}, h, dx);
  ASSERT_EQ(f.count, 2U);
  expectFace(f.face[0], 0.05, {1, 0, 0});
  expectFace(f.face[1], 0.1, {-1, 0, 0});
}

TEST(Faces, AConvexEdgeAndACurvedWallHaveOne) {
  // convex edge of the tank's rim
  EXPECT_EQ(facesWithin(tank(), {-0.98, 0, 1.02}, h, dx).count, 1U);
  const auto block = std::make_shared<BoxDistance>(Vec3d{4, 4, 4});
  const CombinedDistance hollow(CombinedDistance::Kind::Difference,
                                {block, std::make_shared<SphereDistance>(1.0)});
  EXPECT_EQ(facesWithin(hollow, {0.57, 0.57, 0.5}, h, dx).count, 1U);
  EXPECT_EQ(facesWithin(SphereDistance(1), {0, 0, 1.1}, h, dx).count, 1U);
}

TEST(Faces, ACupHasFloorAndSide) {
  const RevolvedDistance cup(glassOutline(1, 1, 0.2));
  const Faces f = facesWithin(cup, {0.75, 0, 0.26}, h, dx);
  ASSERT_EQ(f.count, 2U);
  expectFace(f.face[0], 0.05, {-1, 0, 0});
  expectFace(f.face[1], 0.06, {0, 0, 1});
}

TEST(Faces, AFarPointHasNone) { EXPECT_EQ(facesWithin(tank(), {0, 0, 0.5}, h, dx).count, 0U); }

}  // namespace
}  // namespace thaw::test
