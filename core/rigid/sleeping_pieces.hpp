// SPDX-License-Identifier: Apache-2.0
// Sleep of rigid pieces. A piece is at rest in a step if
//   - its speed is below numerics.sleep_speed,
//   - its acceleration is below sleep_speed / sleep_after and half of gravity,
//   - only weight and contacts load it.
// Pieces::restTime is the duration of rest. A piece falls asleep when it and all pieces that it touches have
// a rest time of sleep_after. No obstacle that it touches may move. An impulse balances the weight of a
// sleeping piece, so it stays in place. Other pieces cannot move it. It wakes when
//   - a moving piece touches it (in the same step, before impulses are found),
//   - a moving obstacle touches it, or an obstacle vanishes,
//   - it has another load, for example from liquid that has appeared next to it,
//   - particles near it join or leave pieces.
// These decisions follow from rows of pieces, which have the same bits on all ranks, and from sums over
// contacts.
#pragma once
#include <span>
#include <vector>

#include "core/halo/halos.hpp"
#include "core/rigid/contact/find_contacts.hpp"
#include "core/rigid/rigid_view.hpp"

namespace thaw {

/// Wakes all pieces.
void wakePieces(Pieces& pieces);

/// Wakes pieces with loads other than their weight. Wakes all pieces if an obstacle vanishes in the last or
/// the next step. dt: s, next step.
void wakeLoaded(const RigidView& view, double dt);

/// Wakes pieces near particles that join or leave pieces, because the pieces may have lost their support.
/// Requires: Continuum::setLabel is set for the new pieces, and rows of the former pieces of owned particles
/// and ghosts exist. Collective.
void wakeNearChanges(const RigidView& view, Reducer& all);

/// Wakes sleeping pieces that a moving piece or obstacle touches. Returns true if any piece woke on any rank.
/// Collective.
bool wakeTouched(const RigidView& view, std::span<const FoundContact> contacts, Reducer& all);

/// Makes sleeping pieces immovable for the contact solver.
void holdSleeping(const Pieces& pieces, std::span<PieceMotion> motions);

/// Contacts of the next step, and the resulting motion.
struct RestInput {
  std::span<const FoundContact> contacts;
  std::span<const PieceMotion> after;  ///< motion of each row in that step
  double dt;                           ///< s, length of that step
};

/// Updates rest times, and the sleep state of pieces. Collective.
void updateRest(const RigidView& view, const RestInput& input, Reducer& all);

/// Sets the impulses of sleeping pieces for the next step, of dt (s). The impulses bring the pieces to rest.
void balanceSleeping(Pieces& pieces, double dt);

/// Returns the number of particles of this rank in sleeping pieces.
std::int64_t countAsleep(const Pieces& pieces);

}  // namespace thaw
