// The oriented bodies' part of a step.
#pragma once
#include "core/step.hpp"

namespace thaw {

/// Carries all oriented particles over dt (s) from the forces of the last evaluation, anchors too. Needs them
/// ready (evaluateOriented). Collective. What contacts with other kinds gave their other ends in the last
/// half step is given now; a report counts it as under way (LedgerReport::underWay).
void stepOriented(World& world, Halos halos, StepTools& tools, double dt);

/// Events whose time has come in the step of dt (s) that led here (with OrientedWork::begins also those of
/// time 0), births and deaths where they are due, then forces. Needs rows at home. Collective.
void evaluateOriented(World& world, Halos halos, StepTools& tools, double dt);

/// Behind all contacts with other kinds: those of particles born in this evaluation begin pressed in, with
/// energy that no motion has brought.
void bookBornContacts(World& world, const StepTools& tools);

/// Gives at once what contacts with other kinds have under way, and forgets the last step: before forces of
/// other coefficients follow, of which the other ends get the first half.
void giveUnderWay(World& world);

/// Symplectic Euler gives a force the half of the way of the step of dt (s) that led to it only with the next
/// kick (symplectic.cpp): that of a force that is another one by then belongs to what changed it. Adds `sign`
/// times it (J): 1 with the force before, -1 with that after, or the other way round.
void bookLag(const World& world, const StepTools& tools, double sign, double dt, ExactSum& to);

/// The longest step (s) that is stable for this rank's particles; `never` without any. To be reduced over
/// ranks.
double orientedStepLimit(const World& world, const StepTools& tools);

/// Contact of oriented particles with the continuum: springs, dashpots and barriers between centres
/// (plan_contact.hpp); half of the energy is booked at each end. Notes how short the next step has to be for
/// them (OrientedWork::fastest2), also for what comes into contact in it. Needs forces and ghosts of both.
/// Not collective.
void meetContinuum(World& world, StepTools& tools, double dt);

}  // namespace thaw
