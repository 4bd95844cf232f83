// SPDX-License-Identifier: Apache-2.0
// Approximate signed distances of simple shapes, negative inside, and their blends.
#pragma once
#include <algorithm>
#include <cmath>

#include "core/math/vec3.hpp"

namespace thaw {

/// Returns the union, with the seam rounded over a width k. The blend is quadratic, to avoid transcendental
/// functions.
inline double blend(double a, double b, double k) {
  const double h = std::max(k - std::abs(a - b), 0.0) / k;
  return std::min(a, b) - 0.25 * k * h * h;
}
/// Returns a without b, with the edge rounded over k.
inline double carve(double a, double b, double k) { return -blend(-a, b, k); }

inline double ellipsoid(const Vec3d& x, const Vec3d& centre, const Vec3d& radii) {
  const Vec3d d = x - centre, p{d.x / radii.x, d.y / radii.y, d.z / radii.z},
              q{p.x / radii.x, p.y / radii.y, p.z / radii.z};
  const double k = length(p), g = length(q);
  return g > 0 ? k * (k - 1) / g : -std::min({radii.x, radii.y, radii.z});
}

/// Cone with round ends from a to b; the radius varies linearly.
inline double limb(const Vec3d& x, const Vec3d& a, const Vec3d& b, double radiusA, double radiusB) {
  const Vec3d e = b - a;
  const double t = std::clamp(dot(x - a, e) / dot(e, e), 0.0, 1.0);
  return length(x - a - e * t) - (radiusA + t * (radiusB - radiusA));
}

}  // namespace thaw
