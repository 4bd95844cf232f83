// SPDX-License-Identifier: Apache-2.0
// Smallest angles of triangles.
#pragma once
#include <algorithm>
#include <cmath>

#include "core/math/vec3.hpp"

namespace thaw {

/// Returns the largest cosine of a triangle's angles, which is that of its smallest angle. Returns 1 for a
/// triangle without area.
inline double sharpestCosine(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  const Vec3d u = b - a, v = c - b, w = a - c;
  const double u2 = dot(u, u), v2 = dot(v, v), w2 = dot(w, w);
  const double least = std::min({u2, v2, w2});
  if (!(least > 0)) return 1;
  // opposite to the shortest edge
  const double cosine = least == u2   ? -dot(v, w) / std::sqrt(v2 * w2)
                        : least == v2 ? -dot(w, u) / std::sqrt(w2 * u2)
                                      : -dot(u, v) / std::sqrt(u2 * v2);
  return std::min(1.0, cosine);
}

/// Returns the smallest angle of a triangle in radians.
inline double smallestAngle(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  return std::acos(std::max(-1.0, sharpestCosine(a, b, c)));
}

}  // namespace thaw
