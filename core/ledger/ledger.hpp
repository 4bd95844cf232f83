// The books of a run: what there is, what came in, what left, what was dissipated, and the residual that no
// term explains.
#pragma once
#include <cstdint>

#include "core/math/exact_sum.hpp"
#include "core/math/vec3.hpp"

namespace thaw {

/// A set of conserved quantities. SI; angular momentum about the origin.
struct Balance {
  double mass = 0;                                               // kg
  Vec3d momentum{}, angularMomentum{};                           // kg m/s, kg m^2/s
  double kinetic = 0, elastic = 0, potential = 0, internal = 0;  // J; internal: heat and latent heat;
                                                                 // potential: gravity and contacts
};

/// The same, exact and addable over ranks.
struct ExactBalance {
  ExactSum mass, momentum[3], angularMomentum[3], kinetic, elastic, potential, internal;
};

/// Flows since the start, on this rank only; the sum over ranks counts. In every checkpoint.
struct Ledger {
  ExactBalance entered, left;  ///< emitters, open sides
  ExactSum dissipated;         ///< J, of particles that left or that changed hands; the rest is in
                               ///< Continuum::dissipated
  ExactSum wallWork;           ///< J, done on particles by moving obstacles and by emitters
  ExactSum wallImpulse[3];     ///< N s, given to particles by obstacles, and by what holds clamped ones
  ExactSum wallForce[3];       ///< N, of these now: half of the next kick is still to come
  ExactSum gravityImpulse[3];  ///< N s, of mass that entered, less that of mass that left; initial.mass * g *
                               ///< time is to be added
  ExactSum heatIn;             ///< J, through obstacles, sources and surfaces
  ExactSum phaseJump;    ///< J, elastic energy that melting, freezing, breaking and re-referencing removed (>
                         ///< 0) or made
  ExactSum restartJump;  ///< J, stored energy that new coefficients at a restart made (> 0) or took
  Balance initial;       ///< global, at time 0
};

}  // namespace thaw
