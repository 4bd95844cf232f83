// SPDX-License-Identifier: Apache-2.0
#include "core/surface/relaxation/wall_projection.hpp"

#include "core/math/tangent.hpp"

namespace thaw {
namespace {

/// Maximum number of projections. Where walls meet, a projection out of one wall may lead into another.
constexpr int mostPushes = 8;
/// Wall thickness, in particle spacings, below which surfels may have passed through a wall. Also the search
/// radius for their particles.
constexpr double thin = 1.5;
/// Distance, in spacings of surfels, within which a surfel that faces a wall lies on the wall.
constexpr double onWallDistance = 0.02;

/// The same for surfels that rest on a wall, and cosine of their largest angle between normal and direction
/// into the wall.
constexpr double restingDistance = 0.1, restingCosine = 0.7;

/// Projects x out of one wall. Returns whether it was inside.
bool outOf(const SurfaceView& w, const Wall& wall, const Vec3d& outward, Vec3d& x) {
  const Vec3d rest = toRest(wall.pose, x);
  if (!nearBounds(wall.bounds, rest, 0)) return false;
  Vec3d n;
  const double d = wall.shape->distanceWithin(rest, w.grid.support, &n);
  if (!(d < 0)) return false;
  if (n = directionFromRest(wall.pose, n); dot(n, outward) <= 0.5) {
    x -= d * n;
    return true;
  }
  // moves back into the body until the position leaves the wall
  Vec3d back = x;
  double inside = d, gone = 0;
  for (const double longest = 2 * w.scene.spacing; inside < 0 && gone < longest;) {
    const double step = 1e-3 * w.scene.spacing - inside;
    gone += step;
    back -= step * outward;
    inside = wall.shape->distanceWithin(toRest(wall.pose, back), w.grid.support, nullptr);
  }
  x = inside < 0 ? x - d * n : back;
  return true;
}

/// Returns the first contact of the segment from `from` (outside) to `to` with a wall, or `to` without
/// contact.
Vec3d stopAt(const Wall& wall, const Vec3d& from, const Vec3d& to, double reach) {
  const double far = length(to - from);
  if (!(far > 0)) return to;
  const Vec3d along = (to - from) / far;
  double gone = 0;
  for (int step = 0; step < 64; step++) {
    const double d = wall.shape->distanceWithin(toRest(wall.pose, from + gone * along), reach, nullptr);
    if (d < 1e-3 * far) return from + gone * along;
    gone += d;
    if (gone >= far) return to;
  }
  return from + gone * along;
}

/// Returns surfels that passed through a thin wall to the side of their nearest particle.
class ThinWalls {
 public:
  ThinWalls(const SurfaceView& w, const Bins& bins) : view_(w), bins_(bins), reach_(thin * w.scene.spacing) {}
  Vec3d back(std::size_t i, const Vec3d& x) const {
    Vec3d at = x, particle;
    bool looked = false;
    for (const Wall& wall : view_.walls.list) {
      const Vec3d rest = toRest(wall.pose, at);
      if (!wall.present || !nearBounds(wall.bounds, rest, reach_)) continue;
      Vec3d n;
      const double d = wall.shape->distanceWithin(rest, reach_, &n);
      // The wall is thick here, so no surfel passes through.
      if (!(d < reach_) || !(wall.shape->distanceWithin(rest - (d + reach_) * n, reach_, nullptr) >= 0))
        continue;
      if (!looked && !nearest(i, at, particle)) return at;
      looked = true;
      const double from = wall.shape->distanceWithin(toRest(wall.pose, particle), reach_, nullptr);
      if (from > 0 && from + d < length(particle - at)) at = stopAt(wall, particle, at, reach_);
    }
    return at;
  }

 private:
  bool nearest(std::size_t i, const Vec3d& x, Vec3d& found) const {
    const SurfaceParticles& p = view_.surface.particles;
    double least = reach_ * reach_;
    std::uint64_t id = ~std::uint64_t{0};
    forRowsWithin(bins_, x, reach_, [&](std::uint32_t j, double d2) {
      if (p.component[j] != view_.surface.surfels.component[i] || d2 > least || (d2 == least && p.id[j] > id))
        return;
      least = d2;
      id = p.id[j];
      found = p.position[j];
    });
    return id != ~std::uint64_t{0};
  }
  const SurfaceView& view_;
  const Bins& bins_;
  double reach_;
};

/// Returns whether the normal faces a wall within `near` (m): the cosine of its angle to `into`, the
/// direction into the wall, exceeds `cosine`.
bool facesWallWithin(const SurfaceView& w, const Vec3d& x, const Vec3d& normal, double near, double cosine,
                     Vec3d& into) {
  for (const Wall& wall : w.walls.list) {
    const Vec3d rest = toRest(wall.pose, x);
    if (!wall.present || !nearBounds(wall.bounds, rest, near)) continue;
    Vec3d n;
    if (!(wall.shape->distanceWithin(rest, w.grid.support, &n) < near)) continue;
    into = -1.0 * directionFromRest(wall.pose, n);
    if (dot(into, normal) > cosine) return true;
  }
  return false;
}

/// Sets the normal of a surfel and rotates its tangent.
void turnTo(Surfels& f, std::size_t i, const Vec3d& normal) {
  f.normal[i] = normal;
  const Vec3d across = f.tangent[i] - dot(f.tangent[i], normal) * normal;
  f.tangent[i] = dot(across, across) > 1e-6 ? normalized(across) : anyTangent(normal);
}

}  // namespace

Vec3d projectedOutOfWalls(const SurfaceView& w, const Vec3d& at, const Vec3d& outward) {
  Vec3d x = at;
  for (int round = 0, pushes = 1; round < mostPushes && pushes > 0; round++) {
    pushes = 0;
    for (const Wall& wall : w.walls.list) pushes += wall.present && outOf(w, wall, outward, x);
    if (w.walls.list.size() < 2) break;
  }
  return x;
}

bool inWall(const SurfaceView& w, const Vec3d& x) {
  for (const Wall& wall : w.walls.list) {
    const Vec3d rest = toRest(wall.pose, x);
    if (wall.present && nearBounds(wall.bounds, rest, 0) &&
        wall.shape->distanceWithin(rest, w.grid.support, nullptr) < 0)
      return true;
  }
  return false;
}

bool facesWall(const SurfaceView& w, const Vec3d& x, const Vec3d& normal, Vec3d& into) {
  return facesWallWithin(w, x, normal, onWallDistance * w.surface.spacing, 0.3, into);
}

void alignWithWalls(const SurfaceView& w, const std::vector<std::uint8_t>& listed) {
  Surfels& f = w.surface.surfels;
  if (!f.wallOffset.active) return;
  f.activate(f.wallAligned);
  for (std::size_t i = 0; i < f.owned; i++) {
    Vec3d into;
    f.wallAligned[i] = listed[i] && facesWallWithin(w, f.position[i], f.normal[i],
                                                    restingDistance * w.surface.spacing, restingCosine, into);
    if (f.wallAligned[i]) turnTo(f, i, into);
  }
}

void projectOutOfWalls(const SurfaceView& w, const Bins& particleBins) {
  Surfels& f = w.surface.surfels;
  if (!f.wallOffset.active) return;
  const ThinWalls thinWalls(w, particleBins);
  for (std::size_t i = 0; i < f.owned; i++) {
    const Vec3d from = f.position[i], to = thinWalls.back(i, projectedOutOfWalls(w, from, f.normal[i])),
                push = to - from;
    if (dot(push, push) > 0) {
      f.position[i] = to;
      f.wallOffset[i] = (1 - liquidShare(f, i)) * push;
    }
    Vec3d into;
    if (!(liquidShare(f, i) > 0.5) || !facesWall(w, to, f.normal[i], into)) continue;
    turnTo(f, i, into);
  }
}

void reprojectOutOfWalls(const SurfaceView& w) {
  Surfels& f = w.surface.surfels;
  if (!f.wallOffset.active) return;
  for (std::size_t i = 0; i < f.owned; i++) {
    f.position[i] = projectedOutOfWalls(w, f.position[i], f.normal[i]);
    Vec3d into;
    f.onWall[i] = facesWall(w, f.position[i], f.normal[i], into);
  }
}

void removeWallOffsets(Surfels& f) {
  if (!f.wallOffset.active) return;
  for (std::size_t i = 0; i < f.owned; i++) f.position[i] -= f.wallOffset[i], f.wallOffset[i] = {};
}

}  // namespace thaw
