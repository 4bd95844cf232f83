// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/trees/triangle_bvh.hpp"

#include <gtest/gtest.h>

#include "tests/support/meshes.hpp"

namespace thaw {
namespace {

TriangleMesh soup(int n) {
  TriangleMesh m;
  for (int t = 0; t < n; t++) {
    const Vec3d c = randomPoint({{-1, -1, -1}, {1, 1, 1}}, static_cast<std::uint64_t>(t));
    for (std::uint64_t k = 0; k < 3; k++)
      m.vertices.push_back(
          c + 0.2 * randomPoint({{-1, -1, -1}, {1, 1, 1}}, 1000000 + 3 * static_cast<std::uint64_t>(t) + k));
    const auto v = static_cast<std::uint32_t>(3 * t);
    m.triangles.push_back({v, v + 1, v + 2});
  }
  // triangles without area: a point, a segment
  m.triangles.push_back({0, 0, 0});
  m.triangles.push_back({3, 4, 3});
  return m;
}

TEST(TriangleBvh, ClosestPointsEqualBruteForce) {
  const TriangleMesh m = soup(500);
  const TriangleBvh tree(m);
  for (std::uint64_t k = 0; k < 2000; k++) {
    const Vec3d x = randomPoint({{-2, -2, -2}, {2, 2, 2}}, 5000000 + k);
    const double d = bruteDistance(m, x);
    const ClosestPoint c = tree.closest(x);
    ASSERT_NEAR(std::sqrt(c.distance2), d, 1e-13);
    ASSERT_NEAR(length(c.point - x), d, 1e-13);
    ASSERT_EQ(tree.closest(x, 0.999 * d).distance2, never);
    ASSERT_NEAR(std::sqrt(tree.closest(x, 1.001 * d).distance2), d, 1e-13);
  }
}

TEST(TriangleBvh, ClosestPointOfATriangleInAllItsRegions) {
  const Vec3d a{0, 0, 0}, b{1, 0, 0}, c{0, 2, 0};
  const auto is = [&](const Vec3d& x, const Vec3d& p) {
    EXPECT_LT(length(closestPointOfTriangle(a, b, c, x) - p), 1e-14) << x.x << " " << x.y << " " << x.z;
  };
  is({0.2, 0.3, 5}, {0.2, 0.3, 0});
  is({-1, -1, 1}, a);
  is({3, -1, 1}, b);
  is({-1, 4, 1}, c);
  is({0.5, -1, -2}, {0.5, 0, 0});
  is({-1, 1, 0}, {0, 1, 0});
  is({1.4, 1.2, 0}, {0.6, 0.8, 0});
  // an obtuse triangle from beyond its long edge, and one without area
  EXPECT_LT(length(closestPointOfTriangle({0, 0, 0}, {4, 0, 0}, {2, 0.1, 0}, {3.9, 1, 0}) -
                   Vec3d{3.850374065, 0.007481297, 0}),
            1e-6);
  EXPECT_LT(length(closestPointOfTriangle({0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1.7, 1, 0}) - Vec3d{1.7, 0, 0}),
            1e-14);
}

TEST(TriangleBvh, WindingNumbersEqualBruteForce) {
  const TriangleMesh m = soup(1500), ball = ballMesh({0.1, 0.2, 0.3}, 0.7, 0.06);
  double worst = 0, worstBall = 0;
  const TriangleBvh tree(m), ballTree(ball);
  for (std::uint64_t k = 0; k < 1000; k++) {
    const Vec3d x = randomPoint({{-1.2, -1.2, -1.2}, {1.2, 1.2, 1.2}}, 7000000 + k);
    worst = std::max(worst, std::abs(tree.winding(x) - bruteWinding(m, x)));
    const double exact = length(x - Vec3d{0.1, 0.2, 0.3}) < 0.7 ? 1 : 0;
    if (std::abs(length(x - Vec3d{0.1, 0.2, 0.3}) - 0.7) < 0.01) continue;
    worstBall = std::max(worstBall, std::abs(ballTree.winding(x) - exact));
    ASSERT_NEAR(bruteWinding(ball, x), exact, 1e-12);
    ASSERT_NEAR(ballTree.winding(x, 1e9), exact, 1e-12);  // no dipoles
  }
  EXPECT_LT(worst, 0.1);
  EXPECT_LT(worstBall, 0.1);
}

TEST(TriangleBvh, EqualTrianglesMakeNoDeepTree) {
  TriangleMesh m;
  m.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  m.triangles.assign(100000, {0, 1, 2});
  const TriangleBvh tree(m);
  EXPECT_DOUBLE_EQ(std::sqrt(tree.closest({0.2, 0.2, 3}).distance2), 3);
  EXPECT_EQ(TriangleBvh(TriangleMesh{}).closest({0, 0, 0}).distance2, never);
}

}  // namespace
}  // namespace thaw
