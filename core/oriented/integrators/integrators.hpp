// SPDX-License-Identifier: Apache-2.0
// The three integrators of oriented particles. Each requires forces at the current positions, and updates the
// owned rows; ghosts keep their old values. Each records the work of obstacles, fields and damping in its own
// quadrature. Each sets OrientedWork::acting and actingTorque to the mean force and torque of all rows,
// including fixed ones.
#pragma once
#include "core/halo/halos.hpp"
#include "core/oriented/data/oriented_view.hpp"

namespace thaw {

/// Symplectic Euler: v += a dt, then x += v dt, and the same for rotations. Damping is exact, exp(-c dt), in
/// the middle of the kick. The scheme's energy error for a changing step is recorded as dissipation. The
/// work of pressure and external forces is recorded as external work.
void stepSymplectic(const OrientedView& view, double dt);

/// Fourth-order Runge-Kutta, also for quaternions. Obstacles keep their pose from the start of the step, and
/// contact forces with the continuum are constant. Collective.
void stepRungeKutta(const OrientedView& view, Halos halos, double dt);

/// Linearised backward Euler: (M (1 + c dt) + dt^2 K) v = M v + dt f, solved by conjugate gradients (HS52). K
/// is the positive part of the pair stiffness (Gauss-Newton with fixed weights). The scheme is stable far
/// beyond explicit steps. Its numerical loss is recorded as dissipation. Collective.
void stepSemiImplicit(const OrientedView& view, Halos halos, double dt);

}  // namespace thaw
