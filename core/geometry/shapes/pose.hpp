// SPDX-License-Identifier: Apache-2.0
// Position, orientation and velocity of a moving obstacle.
#pragma once
#include <vector>

#include "core/math/mat3.hpp"
#include "core/math/vec3.hpp"
#include "core/scene/scene.hpp"

namespace thaw {

/// x = move + rotation * x_rest.
struct Pose {
  Vec3d move{};                          ///< m
  Vec3d rotate{};                        ///< rad, about x, then y, then z
  Vec3d velocity{};                      ///< m/s, at the moved origin
  Vec3d angularVelocity{};               ///< rad/s, about the moved origin, in the axes of the scene
  Mat3d rotation = identity3<double>();  ///< rotation matrix of `rotate`
  bool moved = false;                    ///< false: the rest pose; positions keep their bits
};

/// Returns the pose at a time (s). Position and angles are linear between keyframes, and constant before the
/// first and after the last. Times of keyframes ascend; of equal times, the last one counts. At a keyframe,
/// the velocity is that of the interval that begins there.
Pose poseAt(const std::vector<Keyframe>& motion, double time);

/// Returns a static pose with this move (m) and these angles (rad).
Pose poseOf(const Vec3d& move, const Vec3d& rotate);

Vec3d toRest(const Pose& pose, const Vec3d& x);    ///< maps a point of the scene to the rest frame, m
Vec3d fromRest(const Pose& pose, const Vec3d& x);  ///< inverse of toRest
Vec3d directionFromRest(const Pose& pose, const Vec3d& n);  ///< maps a gradient to the scene
Vec3d velocityAt(const Pose& pose, const Vec3d& x);  ///< m/s, velocity of the moving body at a point of the
                                                     ///< scene

}  // namespace thaw
