// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/shapes/primitives.hpp"

#include <algorithm>
#include <cmath>

namespace thaw {

double BoxDistance::distance(const Vec3d& x, Vec3d* gradient) const {
  Vec3d q, out;
  for (int a = 0; a < 3; a++) {
    q[a] = std::abs(x[a]) - half_[a];
    out[a] = std::max(q[a], 0.0);
  }
  const auto sided = [&](int a, double v) { return x[a] < 0 ? -v : v; };
  const double outside = length(out);
  if (outside > 0) {
    if (gradient) *gradient = Vec3d{sided(0, out.x), sided(1, out.y), sided(2, out.z)} / outside;
    return outside;
  }
  const int axis = q.x >= q.y && q.x >= q.z ? 0 : q.y >= q.z ? 1 : 2;
  if (gradient) {
    *gradient = {};
    (*gradient)[axis] = sided(axis, 1);
  }
  return q[axis];
}

double SphereDistance::distance(const Vec3d& x, Vec3d* gradient) const {
  const double r = length(x);
  if (gradient) *gradient = r > 0 ? x / r : Vec3d{1, 0, 0};
  return r - radius_;
}

double TorusDistance::distance(const Vec3d& x, Vec3d* gradient) const {
  const double rho = std::sqrt(x.x * x.x + x.y * x.y);
  const Vec3d radial = rho > 0 ? Vec3d{x.x / rho, x.y / rho, 0} : Vec3d{1, 0, 0};
  const double u = rho - ring_, d = std::sqrt(u * u + x.z * x.z);
  if (gradient) *gradient = d > 0 ? (radial * u + Vec3d{0, 0, x.z}) / d : radial;
  return d - tube_;
}

double TorusDistance::extent(const Vec3d& n) const {
  return ring_ * std::sqrt(n.x * n.x + n.y * n.y) + tube_ * length(n);
}

double HalfSpaceDistance::distance(const Vec3d& x, Vec3d* gradient) const {
  if (gradient) *gradient = normal_;
  return dot(normal_, x) - offset_;
}

double HalfSpaceDistance::alongNormal(const Vec3d& direction, const Vec3d& normal, double offset) {
  const double l = length(direction);
  if (l == 0) return 0;
  // The tolerance allows for rounding of a rotated direction.
  return length(direction / l - normal) < 1e-12 ? l * offset : never;
}

RevolvedDistance::RevolvedDistance(std::vector<Point> outline) : outline_(std::move(outline)), convex_(true) {
  for (std::size_t k = 2; k < outline_.size(); k++) {
    const Point &a = outline_[k - 2], &b = outline_[k - 1], &c = outline_[k];
    convex_ = convex_ && (b.r - a.r) * (c.z - b.z) - (b.z - a.z) * (c.r - b.r) >= 0;  // the outline never
                                                                                      // turns right
  }
}

double RevolvedDistance::distance(const Vec3d& x, Vec3d* gradient) const {
  const double r = std::sqrt(x.x * x.x + x.y * x.y), z = x.z;
  double best = never, gr = 0, gz = 0, nr = 0, nz = 0, size = 0;
  bool inside = false;
  for (std::size_t k = 0; k + 1 < outline_.size(); k++) {
    const Point a = outline_[k], b = outline_[k + 1];
    const double er = b.r - a.r, ez = b.z - a.z, l2 = er * er + ez * ez;
    const double t = l2 > 0 ? std::clamp(((r - a.r) * er + (z - a.z) * ez) / l2, 0.0, 1.0) : 0;
    const double dr = r - (a.r + t * er), dz = z - (a.z + t * ez), d2 = dr * dr + dz * dz;
    if (d2 < best) {
      const double l = std::sqrt(l2);
      best = d2, gr = dr, gz = dz, nr = ez / l, nz = -er / l;  // the solid is on the left, the normal on the
                                                               // right
    }
    size = std::max({size, std::abs(b.r), std::abs(b.z)});
    // Counts crossings of the ray from (r, z) away from the axis.
    if ((a.z > z) != (b.z > z) && r < a.r + (z - a.z) / ez * er) inside = !inside;
  }
  const double d = std::sqrt(best);
  if (gradient) {
    if (d > 1e-12 * size) {
      const double s = (inside ? -1 : 1) / d;
      nr = gr * s, nz = gz * s;
    }
    *gradient = r > 0 ? Vec3d{nr * x.x / r, nr * x.y / r, nz} : Vec3d{nr, 0, nz};
  }
  return inside ? -d : d;
}

double RevolvedDistance::extent(const Vec3d& n) const {
  double e = -never;
  for (const Point& p : outline_) e = std::max(e, p.r * std::sqrt(n.x * n.x + n.y * n.y) + p.z * n.z);
  return e;
}

std::vector<RevolvedDistance::Point> cylinderOutline(double radius, double height) {
  const double h = 0.5 * height;
  return {{0, -h}, {radius, -h}, {radius, h}, {0, h}};
}

std::vector<RevolvedDistance::Point> glassOutline(double radius, double height, double thickness) {
  return {{0, 0},
          {radius, 0},
          {radius, height},
          {radius - thickness, height},
          {radius - thickness, thickness},
          {0, thickness}};
}

}  // namespace thaw
