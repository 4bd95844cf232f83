// The nearest point of a triangle by shares of its corners.
#include "core/sheet/face_contact.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/geometry/triangle_bvh.hpp"
#include "core/math/hash_random.hpp"

namespace thaw {
namespace {

TEST(FaceContact, SharesAreThoseOfTheNearestPoint) {
  std::uint64_t n = 0;
  const auto random = [&] { return 2 * randomUniform(7, Purpose::Jitter, n++) - 1; };
  const auto place = [&] { return Vec3d{random(), random(), random()}; };
  for (int k = 0; k < 5000; k++) {
    const Vec3d a = place(), b = place(), c = k % 10 == 0 ? 0.5 * (a + b) : place(), x = 2.0 * place();  // some without area
    const Vec3d u = sharesOfNearest(a, b, c, x), at = u.x * a + u.y * b + u.z * c;
    EXPECT_NEAR(u.x + u.y + u.z, 1, 1e-15);
    EXPECT_GE(std::min({u.x, u.y, u.z}), -1e-15);
    EXPECT_NEAR(length(at - x), length(closestPointOfTriangle(a, b, c, x) - x), 1e-7);
  }
}

}  // namespace
}  // namespace thaw
