// SPDX-License-Identifier: Apache-2.0
// Unit quaternions as rotations.
#pragma once
#include <cmath>

#include "core/math/vec3.hpp"

namespace thaw {

struct Quat {
  double w = 1, x = 0, y = 0, z = 0;
};

inline Quat operator*(const Quat& a, const Quat& b) {
  return {a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
          a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x, a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
}
/// The inverse rotation.
inline Quat conjugate(const Quat& q) { return {q.w, -q.x, -q.y, -q.z}; }
inline Quat unitQuat(const Quat& q) {
  const double l = std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
  return {q.w / l, q.x / l, q.y / l, q.z / l};
}
/// Rotation by the angle |r| (rad) about r.
inline Quat rotationBy(const Vec3d& r) {
  const double angle2 = dot(r, r), angle = std::sqrt(angle2);
  const double s = angle > 1e-4 ? std::sin(0.5 * angle) / angle : 0.5 - angle2 / 48;
  return unitQuat(Quat{angle > 1e-4 ? std::cos(0.5 * angle) : 1 - angle2 / 8, s * r.x, s * r.y, s * r.z});
}
/// Rotation vector (rad) from one orientation to another, along the shorter arc.
inline Vec3d turnBetween(const Quat& from, const Quat& to) {
  Quat q = to * conjugate(from);
  if (q.w < 0) q = {-q.w, -q.x, -q.y, -q.z};
  const Vec3d v{q.x, q.y, q.z};
  const double s = length(v);
  return s > 1e-8 ? (2 * std::atan2(s, q.w) / s) * v : 2.0 * v;
}
inline Vec3d rotated(const Quat& q, const Vec3d& v) {
  const Vec3d u{q.x, q.y, q.z}, t = 2.0 * cross(u, v);
  return v + q.w * t + cross(u, t);
}
/// Third column of the rotation matrix: the image of e_z.
inline Vec3d axisOf(const Quat& q) {
  return {2 * (q.x * q.z + q.w * q.y), 2 * (q.y * q.z - q.w * q.x), 1 - 2 * (q.x * q.x + q.y * q.y)};
}
/// The shortest rotation that turns e_z to the unit vector n; about x for n = -e_z.
inline Quat towards(const Vec3d& n) {
  if (n.z < -1 + 1e-12) return {0, 1, 0, 0};
  return unitQuat(Quat{1 + n.z, -n.y, n.x, 0});
}

}  // namespace thaw
