// SPDX-License-Identifier: Apache-2.0
#include "core/oriented/adaptive_sampling/follow_interpolant.hpp"

#include "core/oriented/adaptive_sampling/adaptive_sampling.hpp"

namespace thaw {
namespace {

constexpr double lost = 0.8;    // spacings, largest distance from the interpolated surface
constexpr double strength = 4;  // ratio of the spring constant to the body's stiffness

bool follows(const Oriented& o, const OrientedWork& work, std::size_t i) {
  return !work.given[o.body[i]].points.empty() && !(o.flags[i] & fixedPosition);
}

/// Finds the nearest position on the interpolated surface. Returns false if its distance exceeds `lost`
/// spacings.
bool nearestOnInterpolant(const Oriented& o, const OrientedWork& work, std::size_t i, Vec3d& place,
                          Vec3d& normal) {
  place = o.position[i], normal = axisOf(o.orientation[i]);
  const double far = lost * work.potentials[o.body[i]].spacing;
  return projectOnInterpolant(work.given[o.body[i]], place, normal) &&
         dot(place - o.position[i], place - o.position[i]) < far * far;
}

}  // namespace

bool isOffInterpolant(const Oriented& o, const OrientedWork& work, std::size_t i) {
  Vec3d place, normal;
  return follows(o, work, i) && !nearestOnInterpolant(o, work, i, place, normal);
}

std::int64_t projectRowsOnInterpolant(const OrientedView& w) {
  Oriented& o = w.oriented.rows;
  std::int64_t dead = 0;
  for (std::size_t i = 0; i < o.owned; i++) {
    if (!follows(o, w.work, i)) continue;
    if (Vec3d place, normal; nearestOnInterpolant(o, w.work, i, place, normal)) {
      o.restPosition[i] = place;
      o.restOrientation[i] = towards(normal);
      continue;
    }
    removeRow(w, i, 0);
    dead++;
  }
  w.counters.orientedDeaths += dead;
  return dead;
}

void addInterpolantForces(const Oriented& o, const OrientedWork& work, const Scene& scene,
                          std::vector<Vec3d>& force, std::vector<Vec3d>& torque) {
  for (std::size_t i = 0; i < o.owned; i++) {
    if (!follows(o, work, i)) continue;
    const double k = strength * scene.oriented[o.body[i]].stiffness, s = work.potentials[o.body[i]].spacing;
    const Vec3d n = axisOf(o.restOrientation[i]);
    force[i] -= (k * dot(o.position[i] - o.restPosition[i], n)) * n;
    torque[i] += (k * s * s) * cross(o.normal[i], n);
  }
}

}  // namespace thaw
