// SPDX-License-Identifier: Apache-2.0
// Motion of rigid pieces and their particles.
#pragma once
#include "core/halo/halo.hpp"
#include "core/rigid/rigid_view.hpp"

namespace thaw {

/// First half kick, impulses of contacts, and drift of all pieces over dt (s). Requires: Continuum::pieceRow.
/// Ensures: particles of pieces have the positions and velocities of their pieces.
void driftPieces(const RigidView& view, double dt);

/// Sums forces and torques of all pieces, and sets Continuum::force of their particles to the force that
/// moves them with their pieces. Collective.
void sumPieceForces(const RigidView& view, Reducer& all);

/// Second half kick over dt / 2 (s), with velocities of particles.
void kickPieces(const RigidView& view, double dt);

/// Adds an impulse (N s) and an angular impulse (N m s) to a piece; the rank that leads it records the loss
/// of kinetic energy as dissipated.
void addImpulse(const RigidView& view, std::size_t row, const Vec3d& impulse, const Vec3d& twist);

/// Angular acceleration (rad/s^2) of a piece.
Vec3d angularAcceleration(const Pieces& pieces, std::size_t row);

}  // namespace thaw
