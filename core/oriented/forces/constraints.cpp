// SPDX-License-Identifier: Apache-2.0
#include "core/oriented/forces/constraints.hpp"

#include <cmath>

#include "core/geometry/shapes/pose.hpp"

namespace thaw {
namespace {

// Converts a rotation matrix to a quaternion (S78).
Quat turnOf(const Mat3d& m) {
  const double trace = m.row[0].x + m.row[1].y + m.row[2].z;
  if (trace > 0)
    return unitQuat(
        Quat{1 + trace, m.row[2].y - m.row[1].z, m.row[0].z - m.row[2].x, m.row[1].x - m.row[0].y});
  if (m.row[0].x >= m.row[1].y && m.row[0].x >= m.row[2].z)
    return unitQuat(Quat{m.row[2].y - m.row[1].z, 1 + m.row[0].x - m.row[1].y - m.row[2].z,
                         m.row[0].y + m.row[1].x, m.row[0].z + m.row[2].x});
  if (m.row[1].y >= m.row[2].z)
    return unitQuat(Quat{m.row[0].z - m.row[2].x, m.row[0].y + m.row[1].x,
                         1 + m.row[1].y - m.row[0].x - m.row[2].z, m.row[1].z + m.row[2].y});
  return unitQuat(Quat{m.row[1].x - m.row[0].y, m.row[0].z + m.row[2].x, m.row[1].z + m.row[2].y,
                       1 + m.row[2].z - m.row[0].x - m.row[1].y});
}

}  // namespace

void moveConstrained(Oriented& o, const Scene& scene, double time, double dt) {
  for (std::size_t i = 0; i < o.owned; i++) {
    if (!(o.flags[i] & (fixedPosition | fixedOrientation))) continue;
    const OrientedBody& body = scene.oriented[o.body[i]];
    const OrientedConstraint* constraint = o.constraint[i] == noConstraint
                                               ? nullptr
                                               : &body.constraints[o.constraint[i]];
    if (constraint && time > constraint->until) {
      o.flags[i] &= creased;
      continue;
    }
    const Pose pose = constraint ? poseAt(constraint->motion, time) : Pose{};
    if (o.flags[i] & fixedPosition) {
      o.position[i] = fromRest(pose, o.restPosition[i]);
      o.velocity[i] = pose.moved && dt > 0 ? velocityAt(pose, o.position[i]) : Vec3d{};
    }
    if (o.flags[i] & fixedOrientation) {
      o.orientation[i] = pose.moved ? unitQuat(turnOf(pose.rotation) * o.restOrientation[i])
                                    : o.restOrientation[i];
      o.spin[i] = pose.moved && dt > 0 ? pose.angularVelocity : Vec3d{};
    }
  }
}

}  // namespace thaw
