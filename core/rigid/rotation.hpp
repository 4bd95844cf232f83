// SPDX-License-Identifier: Apache-2.0
// Torque-free rotation of a rigid body.
#pragma once
#include "core/math/mat3.hpp"
#include "core/math/quat.hpp"

namespace thaw {

/// Returns the orientation of a free body after a time dt (s), exact up to rounding. Its angular momentum (kg
/// m^2/s, along the axes of the domain) is constant. inertia: principal moments (kg m^2). Euler's equations
/// are quadratic, so a recurrence gives the Taylor series of orientation and angular momentum in the body
/// frame.
Quat rotateFreely(const Quat& orientation, const Vec3d& angularMomentum, const Vec3d& inertia, double dt);

/// Returns the rotation that maps the coordinate axes to x, y, z. Requires: x, y, z are orthonormal and
/// right-handed.
Quat quatOf(const Vec3d& x, const Vec3d& y, const Vec3d& z);

}  // namespace thaw
