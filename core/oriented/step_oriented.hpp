// SPDX-License-Identifier: Apache-2.0
// Oriented bodies' part of a step.
#pragma once
#include "core/halo/halos.hpp"
#include "core/oriented/data/oriented_view.hpp"

namespace thaw {

/// Integrates all oriented particles over dt (s) with the forces of the last evaluation, and moves
/// constraints. Also applies the contact impulse with other body types for the last half step. The ledger
/// reports it as in flight (LedgerReport::impulseInFlight). Requires: evaluateOriented. Collective.
void stepOriented(const OrientedView& view, Halos halos, double dt);

/// Applies the events of the last step of dt (s); with OrientedWork::begins, also events at time 0. Then
/// applies adaptive sampling if due, and computes forces. Requires: redistributed rows. Collective.
void evaluateOriented(const OrientedView& view, Halos halos, double dt);

/// Records the contact energy of particles born in this evaluation, since no work produced it. Call after all
/// contacts with other body types.
void recordBirthContacts(const Oriented& rows, const OrientedWork& work, Ledger& ledger);

/// Applies the pending impulse of contacts with other body types and clears the last step length, before
/// coefficients change.
void applyPendingImpulse(Oriented& rows, Clock& clock, Ledger& ledger);

/// Adds `sign` times the kick lag (J) of symplectic Euler. The next kick does half of a force's work for the
/// last step of dt (s). If the force changes in between, the lag belongs to the change. Call with 1 before
/// the change and -1 after it, or reversed.
void recordKickLag(const OrientedView& view, double sign, double dt, ExactSum& to);

/// Returns the longest stable step (s) of this rank's particles; `never` without particles. The caller
/// reduces it over ranks.
double orientedStepLimit(const Oriented& rows, const Scene& scene, const OrientedWork& work);

}  // namespace thaw
