// SPDX-License-Identifier: Apache-2.0
// Nearest points of a triangle and of two edges, as weights of corners.
#include "core/sheet/search/nearest_points.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/geometry/trees/triangle_bvh.hpp"
#include "core/math/hash_random.hpp"

namespace thaw {
namespace {

TEST(NearestPoints, WeightsGiveTheNearestPoint) {
  std::uint64_t n = 0;
  const auto random = [&] { return 2 * randomUniform(7, Purpose::Jitter, n++) - 1; };
  const auto place = [&] { return Vec3d{random(), random(), random()}; };
  for (int k = 0; k < 5000; k++) {
    // some without area
    const Vec3d a = place(), b = place(), c = k % 10 == 0 ? 0.5 * (a + b) : place(), x = 2.0 * place();
    const Vec3d u = sharesOfNearest(a, b, c, x), at = u.x * a + u.y * b + u.z * c;
    EXPECT_NEAR(u.x + u.y + u.z, 1, 1e-15);
    EXPECT_GE(std::min({u.x, u.y, u.z}), -1e-15);
    EXPECT_NEAR(length(at - x), length(closestPointOfTriangle(a, b, c, x) - x), 1e-7);
  }
}

TEST(NearestPoints, NoOtherPointsOfTwoEdgesAreNearer) {
  std::uint64_t n = 0;
  const auto random = [&] { return 2 * randomUniform(7, Purpose::Jitter, n++) - 1; };
  const auto place = [&] { return Vec3d{random(), random(), random()}; };
  for (int k = 0; k < 2000; k++) {
    // some parallel, some without length
    const Vec3d p = place(), u = k % 20 == 0 ? Vec3d{} : place(), q = place(),
                v = k % 10 == 0 ? -0.7 * u : place();
    const EdgeShares at = nearestOfEdges(p, u, q, v);
    const double found = length(p + at.first * u - q - at.second * v);
    EXPECT_GE(std::min(at.first, at.second), 0);
    EXPECT_LE(std::max(at.first, at.second), 1);
    for (int i = 0; i <= 20; i++)
      for (int j = 0; j <= 20; j++) ASSERT_LE(found, length(p + 0.05 * i * u - q - 0.05 * j * v) + 1e-12);
  }
}

}  // namespace
}  // namespace thaw
