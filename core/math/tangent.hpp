// SPDX-License-Identifier: Apache-2.0
// Tangent vectors of a surface.
#pragma once
#include <cmath>

#include "core/math/vec3.hpp"

namespace thaw {

/// Returns the coordinate axis along which the component of n is smallest in magnitude.
inline Vec3d leastAxis(const Vec3d& n) {
  const double x = std::abs(n.x), y = std::abs(n.y), z = std::abs(n.z);
  return x <= y && x <= z ? Vec3d{1, 0, 0} : y <= z ? Vec3d{0, 1, 0} : Vec3d{0, 0, 1};
}

/// Returns a unit vector orthogonal to a unit normal, continuous except at -z (D17).
inline Vec3d anyTangent(const Vec3d& n) {
  const double sign = std::copysign(1.0, n.z), a = -1 / (sign + n.z);
  return normalized({1 + sign * n.x * n.x * a, sign * n.x * n.y * a, -sign * n.x});
}

}  // namespace thaw
