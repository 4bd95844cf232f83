// SPDX-License-Identifier: Apache-2.0
// Oriented bodies' part of a step.
#pragma once
#include "core/halo/halos.hpp"
#include "core/oriented/data/oriented_view.hpp"

namespace thaw {

/// Integrates all oriented particles over dt (s) with the forces of the last evaluation, and moves
/// constraints. Applies the impulse of the last half step of contacts with other body types, which the ledger
/// reports as under way (LedgerReport::impulseInFlight). Requires: evaluateOriented. Collective.
void stepOriented(const OrientedView& view, Halos halos, double dt);

/// Applies due events of the last step of dt (s), also those of time 0 with OrientedWork::begins, then
/// adaptive sampling if due, then computes forces. Requires: redistributed rows. Collective.
void evaluateOriented(const OrientedView& view, Halos halos, double dt);

/// Records the contact energy of particles born in this evaluation, which no motion has produced. Call after
/// all contacts with other body types.
void recordBirthContacts(const Oriented& rows, const OrientedWork& work, Ledger& ledger);

/// Applies the pending impulse of contacts with other body types and clears the last step length, before
/// coefficients change.
void applyPendingImpulse(Oriented& rows, Clock& clock, Ledger& ledger);

/// Adds `sign` times the kick lag (J) of symplectic Euler. Half of a force's work in the last step of dt (s)
/// is only delivered by the next kick. If the force changes in between, that energy belongs to the change:
/// call with 1 before it and -1 after it, or reverse.
void recordKickLag(const OrientedView& view, double sign, double dt, ExactSum& to);

/// Returns the longest stable step (s) of this rank's particles; `never` without any. To be reduced over
/// ranks.
double orientedStepLimit(const Oriented& rows, const Scene& scene, const OrientedWork& work);

}  // namespace thaw
