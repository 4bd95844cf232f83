// SPDX-License-Identifier: Apache-2.0
#include "core/heat/sources/light_ends.hpp"

#include <algorithm>
#include <cmath>

namespace thaw {
namespace {

/// Interval of a ray between two distances (m).
struct Stretch {
  double from, to;
};

/// Returns the part of a stretch within a box.
Stretch within(const LightRay& ray, const Bounds& box, Stretch s) {
  for (int a = 0; a < 3; a++) {
    const double x = ray.start[a], d = ray.direction[a];
    if (d == 0) {
      if (x < box.min[a] || x > box.max[a]) return {0, -1};
      continue;
    }
    const double first = (box.min[a] - x) / d, second = (box.max[a] - x) / d;
    s.from = std::max(s.from, std::min(first, second));
    s.to = std::min(s.to, std::max(first, second));
  }
  return s;
}

/// Returns true for a side of the domain. Such a wall has the default shape, a box, with infinite bounds.
bool isDomainSide(const Wall& w) {
  return w.properties.shape.kind == ShapeKind::Box && !std::isfinite(w.bounds.min.x);
}

/// Returns the distance (m) along the ray to the wall's surface by sphere tracing [H96], or infinity.
double meet(const LightRay& ray, const Wall& w, Stretch s, double spacing) {
  const Vec3d start = toRest(w.pose, ray.start);
  const Vec3d direction = w.pose.moved ? transpose(w.pose.rotation) * ray.direction : ray.direction;
  const LightRay rest{start, direction};
  s = within(rest, w.bounds, s);
  for (double t = s.from; t <= s.to;) {
    const double d = w.shape->distanceWithin(start + direction * t, 4 * spacing);
    if (d < 0) return t;
    t += std::max(d, 0.02 * spacing);
  }
  return never;
}

}  // namespace

double endOf(const LightRay& ray, bool parallel, const LightStops& stops) {
  const Stretch all{parallel ? -never : 0, never}, inside = within(ray, stops.domain, all);
  double end = never;
  for (const Wall& w : stops.walls.list) {
    if (!w.present || isDomainSide(w)) continue;
    const bool finite = std::isfinite(w.bounds.min.x) && std::isfinite(w.bounds.max.x);
    end = std::min(end, meet(ray, w, finite ? all : inside, stops.spacing));
  }
  return end;
}

}  // namespace thaw
