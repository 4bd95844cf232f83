// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <numbers>
#include <utility>

#include "core/geometry/trees/triangle_bvh.hpp"

namespace thaw {
namespace {

using std::numbers::pi;
constexpr std::size_t deepest = 128;  // 40 + 32 levels are enough, since levels below fairDepth halve the
                                      // count

Vec3d closestOfSegment(const Vec3d& a, const Vec3d& b, const Vec3d& x) {
  const Vec3d e = b - a;
  const double t = dot(x - a, e), l = dot(e, e);
  return t <= 0 || !(l > 0) ? a : t >= l ? b : a + e * (t / l);
}

double squaredDistance(const Vec3d& low, const Vec3d& high, const Vec3d& x) {
  double d2 = 0;
  for (int a = 0; a < 3; a++) {
    const double d = std::max(std::max(low[a] - x[a], x[a] - high[a]), 0.0);
    d2 += d * d;
  }
  return d2;
}

}  // namespace

Vec3d closestPointOfTriangle(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& x) {
  const Vec3d n = cross(b - a, c - a);
  const double n2 = dot(n, n);
  // Weights of the corners at the foot of the perpendicular.
  const double wa = dot(cross(c - b, x - b), n), wb = dot(cross(a - c, x - c), n),
               wc = dot(cross(b - a, x - a), n);
  if (n2 > 0 && wa >= 0 && wb >= 0 && wc >= 0) return x - n * (dot(x - a, n) / n2);
  Vec3d best = closestOfSegment(a, b, x);
  double best2 = dot(x - best, x - best);
  for (const Vec3d& p : {closestOfSegment(b, c, x), closestOfSegment(c, a, x)}) {
    const double d2 = dot(x - p, x - p);
    if (d2 < best2) best2 = d2, best = p;
  }
  return best;
}

double windingOfTriangle(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& x) {
  const Vec3d u = a - x, v = b - x, w = c - x;
  const double lu = length(u), lv = length(v), lw = length(w);
  const double volume = dot(u, cross(v, w));
  const double rest = lu * lv * lw + dot(u, v) * lw + dot(v, w) * lu + dot(w, u) * lv;
  return volume == 0 ? 0 : std::atan2(volume, rest) / (2 * pi);  // 0 on the triangle itself: the mean of both
                                                                 // sides
}

ClosestPoint TriangleBvh::closest(const Vec3d& x, double reach) const {
  ClosestPoint result;
  if (nodes_.empty()) return result;
  double best = reach * reach;
  const Corners* nearest = nullptr;
  std::array<std::pair<std::uint32_t, double>, deepest> stack;
  std::size_t top = 0;
  stack[top++] = {0, squaredDistance(nodes_[0].low, nodes_[0].high, x)};
  while (top > 0) {
    const auto [index, d2] = stack[--top];
    if (d2 >= best) continue;
    const Node& node = nodes_[index];
    if (node.count > 0) {
      for (std::uint32_t k = node.first; k < node.first + node.count; k++) {
        const Corners& t = triangles_[k];
        const Vec3d p = closestPointOfTriangle(t.a, t.b, t.c, x);
        const double e2 = dot(x - p, x - p);
        if (e2 < best) best = e2, result.point = p, nearest = &t;
      }
      continue;
    }
    const std::uint32_t left = index + 1, right = node.first;
    const double l = squaredDistance(nodes_[left].low, nodes_[left].high, x),
                 r = squaredDistance(nodes_[right].low, nodes_[right].high, x);
    const bool leftFirst = l <= r;  // the nearer child is visited first
    if (leftFirst ? r < best : l < best) stack[top++] = leftFirst ? std::pair{right, r} : std::pair{left, l};
    if (leftFirst ? l < best : r < best) stack[top++] = leftFirst ? std::pair{left, l} : std::pair{right, r};
  }
  if (nearest) {
    result.distance2 = best;
    result.triangle = numbers_[static_cast<std::size_t>(nearest - triangles_.data())];
    result.normal = normalized(cross(nearest->b - nearest->a, nearest->c - nearest->a));
  }
  return result;
}

bool TriangleBvh::meets(const Bounds& box) const {
  if (nodes_.empty()) return false;
  const auto apart = [&](const Vec3d& low, const Vec3d& high) {
    return low.x > box.max.x || high.x < box.min.x || low.y > box.max.y || high.y < box.min.y ||
           low.z > box.max.z || high.z < box.min.z;
  };
  std::array<std::uint32_t, deepest> stack;
  std::size_t top = 0;
  stack[top++] = 0;
  while (top > 0) {
    const std::uint32_t index = stack[--top];
    const Node& node = nodes_[index];
    if (apart(node.low, node.high)) continue;
    if (node.count == 0) {
      stack[top++] = node.first;
      stack[top++] = index + 1;
      continue;
    }
    for (std::uint32_t k = node.first; k < node.first + node.count; k++) {
      const auto& [a, b, c] = triangles_[k];
      const auto least = [](double p, double q, double r) { return std::min(std::min(p, q), r); };
      const auto most = [](double p, double q, double r) { return std::max(std::max(p, q), r); };
      if (!apart({least(a.x, b.x, c.x), least(a.y, b.y, c.y), least(a.z, b.z, c.z)},
                 {most(a.x, b.x, c.x), most(a.y, b.y, c.y), most(a.z, b.z, c.z)}))
        return true;
    }
  }
  return false;
}

double TriangleBvh::winding(const Vec3d& x, double accuracy) const {
  if (nodes_.empty()) return 0;
  double sum = 0;
  std::array<std::uint32_t, deepest> stack;
  std::size_t top = 0;
  stack[top++] = 0;
  while (top > 0) {
    const std::uint32_t index = stack[--top];
    const Dipole& d = dipoles_[index];
    const Vec3d r = d.centre - x;
    const double r2 = dot(r, r);
    if (r2 > accuracy * accuracy * d.radius2) {
      sum += dot(d.moment, r) / (4 * pi * r2 * std::sqrt(r2));
      continue;
    }
    const Node& node = nodes_[index];
    if (node.count > 0) {
      for (std::uint32_t k = node.first; k < node.first + node.count; k++)
        sum += windingOfTriangle(triangles_[k].a, triangles_[k].b, triangles_[k].c, x);
    } else {
      stack[top++] = node.first;
      stack[top++] = index + 1;
    }
  }
  return sum;
}

}  // namespace thaw
