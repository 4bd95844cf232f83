// SPDX-License-Identifier: Apache-2.0
#include "core/walls/walls.hpp"

#include <cmath>
#include <limits>

namespace thaw {
namespace {

/// Plane of a side of the domain.
class SidePlane : public SignedDistance {
 public:
  SidePlane(int axis, double place, double sign) : axis_(axis), place_(place), sign_(sign) {}
  double distance(const Vec3d& x, Vec3d* gradient) const override {
    if (gradient) {
      *gradient = {};
      (*gradient)[axis_] = sign_;
    }
    return sign_ * (x[axis_] - place_);
  }
  bool convex() const override { return true; }
  Bounds bounds() const override {
    const double inf = std::numeric_limits<double>::infinity();
    return {{-inf, -inf, -inf}, {inf, inf, inf}};
  }

 private:
  int axis_;
  double place_, sign_;
};

}  // namespace

void addDomainWalls(const Domain& d, Walls& walls) {
  for (int a = 0; a < 3; a++)
    for (int high = 0; high < 2; high++) {
      if (d.side[static_cast<std::size_t>(a)][static_cast<std::size_t>(high)] != Side::Wall) continue;
      Wall w;
      w.shape = std::make_shared<SidePlane>(a, high ? d.max[a] : d.min[a], high ? -1 : 1);
      w.bounds = w.shape->bounds();
      w.properties.name = std::string("domain ") + static_cast<char>('x' + a) + (high ? " high" : " low");
      walls.list.push_back(std::move(w));
    }
}

void moveWalls(Walls& walls, double time) {
  for (Wall& w : walls.list) {
    w.present = time < w.properties.until;
    w.pose = poseAt(w.properties.motion, time);
    if (!w.isImage()) continue;
    w.pose.move += w.shift;
    w.pose.moved = true;
  }
}

bool holdsSample(const Wall& wall, const Vec3d& x, double spacing) {
  return wall.present && wall.shape->distanceWithin(toRest(wall.pose, x), spacing) < -0.25 * spacing;
}

Vec3d clearOfWalls(const Walls& walls, double distance, const Vec3d& x) {
  constexpr int mostMoves = 4;
  Vec3d clear = x;
  bool moved = true;
  for (int k = 0; k < mostMoves && moved; k++) {
    moved = false;
    for (const Wall& w : walls.list) {
      const Vec3d rest = toRest(w.pose, clear);
      if (!w.present || !nearBounds(w.bounds, rest, distance)) continue;
      Vec3d normal;
      const double d = w.shape->distanceWithin(rest, 2 * distance, &normal);
      if (d >= distance || d < -distance) continue;
      clear = fromRest(w.pose, rest + normal * (distance * (1 + 1e-9) - d));
      moved = true;
    }
  }
  return clear;
}

Vec3d wallVelocity(const Wall& w, const Vec3d& x) { return velocityAt(w.pose, x); }

}  // namespace thaw
