// The three ways of carrying oriented particles over a step. Each needs forces at the places now, and leaves
// the places (and ghosts' as they were). Each books what obstacles, fields and damping give in its own
// quadrature, and leaves the mean force and torque of all rows, held ones too, in OrientedWork::acting and
// actingTorque.
#pragma once
#include "core/step.hpp"

namespace thaw {

/// v += a dt, then x += v dt and the same of rotations. Damping is exact, in the middle of the kick:
/// velocities decay by exp(-c dt). What the scheme gains or loses as the step grows or shrinks is booked as
/// dissipated, the work of pressure and push as theirs.
void stepSymplectic(World& world, StepTools& tools, double dt);

/// Runge-Kutta of fourth order, of quaternions too. Obstacles stand where they are at the beginning of the
/// step; contact with the continuum is held. Collective.
void stepRungeKutta(World& world, Halos halos, StepTools& tools, double dt);

/// Backward Euler, linearised: (M (1 + c dt) + dt^2 K) v = M v + dt f with the positive part K of the pairs'
/// stiffness (Gauss-Newton, weights held), by conjugate gradients. Stable far beyond the explicit steps; what
/// it loses is booked as dissipated. Collective.
void stepSemiImplicit(World& world, Halos halos, StepTools& tools, double dt);

}  // namespace thaw
