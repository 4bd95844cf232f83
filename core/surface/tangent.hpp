// Directions along a surface.
#pragma once
#include <cmath>

#include "core/math/vec3.hpp"

namespace thaw {

/// A unit vector across a unit normal: always the same one, without a jump but at -z (Duff et al. 2017).
inline Vec3d anyTangent(const Vec3d& n) {
  const double sign = std::copysign(1.0, n.z), a = -1 / (sign + n.z);
  return normalized({1 + sign * n.x * n.x * a, sign * n.x * n.y * a, -sign * n.x});
}

}  // namespace thaw
