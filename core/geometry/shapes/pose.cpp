// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/shapes/pose.hpp"

#include <algorithm>

#include "core/geometry/shapes/combined.hpp"

namespace thaw {
namespace {

/// Returns the angular velocity (rad/s) of R = Rz Ry Rx, with angles (rad) that change at `rates` (rad/s).
/// Each rate acts about its axis, which the later rotations turn.
Vec3d angularVelocityOf(const Vec3d& angles, const Vec3d& rates) {
  const Vec3d aboutX = rotationXyz({0, angles.y, angles.z}) * Vec3d{1, 0, 0},
              aboutY = rotationXyz({0, 0, angles.z}) * Vec3d{0, 1, 0};
  return aboutX * rates.x + aboutY * rates.y + Vec3d{0, 0, rates.z};
}

}  // namespace

Pose poseOf(const Vec3d& move, const Vec3d& rotate) {
  Pose p;
  p.move = move;
  p.rotate = rotate;
  if (!(rotate == Vec3d{})) p.rotation = rotationXyz(rotate);
  p.moved = !(move == Vec3d{}) || !(rotate == Vec3d{});
  return p;
}

Pose poseAt(const std::vector<Keyframe>& motion, double time) {
  if (motion.empty()) return {};
  const auto after = std::upper_bound(motion.begin(), motion.end(), time,
                                      [](double t, const Keyframe& k) { return t < k.time; });
  if (after == motion.begin()) return poseOf(motion.front().move, motion.front().rotate);
  if (after == motion.end()) return poseOf(motion.back().move, motion.back().rotate);
  const Keyframe &a = *(after - 1), &b = *after;
  const double span = b.time - a.time, s = (time - a.time) / span;
  Pose p = poseOf(a.move + (b.move - a.move) * s, a.rotate + (b.rotate - a.rotate) * s);
  p.velocity = (b.move - a.move) / span;
  if (!(a.rotate == b.rotate)) p.angularVelocity = angularVelocityOf(p.rotate, (b.rotate - a.rotate) / span);
  return p;
}

Vec3d toRest(const Pose& p, const Vec3d& x) { return p.moved ? transpose(p.rotation) * (x - p.move) : x; }
Vec3d fromRest(const Pose& p, const Vec3d& x) { return p.moved ? p.rotation * x + p.move : x; }
Vec3d directionFromRest(const Pose& p, const Vec3d& n) { return p.moved ? p.rotation * n : n; }
Vec3d velocityAt(const Pose& p, const Vec3d& x) { return p.velocity + cross(p.angularVelocity, x - p.move); }

}  // namespace thaw
