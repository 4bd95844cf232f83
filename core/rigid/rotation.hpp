// SPDX-License-Identifier: Apache-2.0
// Torque-free rotation of a rigid body.
#pragma once
#include "core/math/mat3.hpp"
#include "core/math/quat.hpp"

namespace thaw {

/// Returns the orientation of a free body after a time dt (s), exact up to rounding. Its angular momentum (kg
/// m^2/s, axes of the domain) is constant, `inertia` are its principal moments (kg m^2). Euler's equations
/// are quadratic, so the Taylor series of orientation and angular momentum in the body frame follow by a
/// recurrence.
Quat rotateFreely(const Quat& orientation, const Vec3d& angularMomentum, const Vec3d& inertia, double dt);

/// Returns the rotation whose images of the axes are the columns of an orthonormal, right-handed matrix.
Quat quatOf(const Vec3d& x, const Vec3d& y, const Vec3d& z);

}  // namespace thaw
