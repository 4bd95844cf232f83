// SPDX-License-Identifier: Apache-2.0
// Motion of rigid pieces and their particles.
#pragma once
#include "core/halo/halo.hpp"
#include "core/rigid/rigid_view.hpp"

namespace thaw {

/// Applies the first half kick, the contact impulses, and the drift of all pieces over dt (s). Requires:
/// Continuum::pieceRow.
/// Ensures: particles of pieces have the positions and velocities of their pieces.
void driftPieces(const RigidView& view, double dt);

/// Sums forces and torques of all pieces. Sets Continuum::force of their particles to the force that moves
/// them with their pieces. Collective.
void sumPieceForces(const RigidView& view, Reducer& all);

/// Applies the second half kick, over dt / 2 (s), and updates the velocities of particles.
void kickPieces(const RigidView& view, double dt);

/// Adds an impulse (N s) and an angular impulse (N m s) to a piece. The rank that leads the piece records the
/// loss of kinetic energy as dissipated.
void addImpulse(const RigidView& view, std::size_t row, const Vec3d& impulse, const Vec3d& twist);

/// Returns the angular acceleration (rad/s^2) of a piece.
Vec3d angularAcceleration(const Pieces& pieces, std::size_t row);

}  // namespace thaw
