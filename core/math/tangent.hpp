// SPDX-License-Identifier: Apache-2.0
// Tangent vectors of a surface.
#pragma once
#include <cmath>

#include "core/math/vec3.hpp"

namespace thaw {

/// Returns a unit vector orthogonal to a unit normal, continuous except at -z (D17).
inline Vec3d anyTangent(const Vec3d& n) {
  const double sign = std::copysign(1.0, n.z), a = -1 / (sign + n.z);
  return normalized({1 + sign * n.x * n.x * a, sign * n.x * n.y * a, -sign * n.x});
}

}  // namespace thaw
