// SPDX-License-Identifier: Apache-2.0
#include "core/sheet/search/nearest_points.hpp"

#include <algorithm>

namespace thaw {

// E05, 5.1.5
Vec3d sharesOfNearest(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& x) {
  const Vec3d ab = b - a, ac = c - a, ap = x - a;
  const double d1 = dot(ab, ap), d2 = dot(ac, ap);
  if (d1 <= 0 && d2 <= 0) return {1, 0, 0};
  const Vec3d bp = x - b;
  const double d3 = dot(ab, bp), d4 = dot(ac, bp);
  if (d3 >= 0 && d4 <= d3) return {0, 1, 0};
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0 && d1 - d3 > 0) {
    const double t = d1 / (d1 - d3);
    return {1 - t, t, 0};
  }
  const Vec3d cp = x - c;
  const double d5 = dot(ab, cp), d6 = dot(ac, cp);
  if (d6 >= 0 && d5 <= d6) return {0, 0, 1};
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0 && d2 - d6 > 0) {
    const double t = d2 / (d2 - d6);
    return {1 - t, 0, t};
  }
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 >= d3 && d5 >= d6 && (d4 - d3) + (d5 - d6) > 0) {
    const double t = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    return {0, 1 - t, t};
  }
  const double all = va + vb + vc;
  if (!(all > 0)) return {1, 0, 0};  // no area
  const double v = vb / all, q = vc / all;
  return {1 - v - q, v, q};
}

// E05, 5.1.9
EdgeShares nearestOfEdges(const Vec3d& p, const Vec3d& u, const Vec3d& q, const Vec3d& v) {
  const Vec3d r = p - q;
  const double a = dot(u, u), e = dot(v, v), f = dot(v, r), c = dot(u, r), b = dot(u, v),
               denominator = a * e - b * b;
  if (!(a > 0)) return {0, e > 0 ? std::clamp(f / e, 0.0, 1.0) : 0};
  if (!(e > 0)) return {std::clamp(-c / a, 0.0, 1.0), 0};
  double s = denominator > 0 ? std::clamp((b * f - c * e) / denominator, 0.0, 1.0) : 0, t = (b * s + f) / e;
  if (t < 0) {
    t = 0;
    s = std::clamp(-c / a, 0.0, 1.0);
  } else if (t > 1) {
    t = 1;
    s = std::clamp((b - c) / a, 0.0, 1.0);
  }
  return {s, t};
}

}  // namespace thaw
