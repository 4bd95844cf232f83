// The oriented bodies' part of a step.
#pragma once
#include "core/step.hpp"

namespace thaw {

/// Carries all oriented particles over dt (s) from the forces of the last evaluation, anchors too. Needs them ready (evaluateOriented). Collective.
void stepOriented(World& world, Halos halos, StepTools& tools, double dt);

/// Events whose time has come in the step of dt (s) that led here (0: those of the start), births and deaths where they are due, then forces.
/// Needs rows at home. Collective.
void evaluateOriented(World& world, Halos halos, StepTools& tools, double dt);

/// The longest step (s) that is stable for this rank's particles; `never` without any. To be reduced over ranks.
double orientedStepLimit(const World& world, const StepTools& tools);

/// Contact of oriented particles with the continuum: springs and dashpots between centres, from 0.55 of the sum of their spacings on; half of the
/// energy is booked at each end. Needs forces and ghosts of both. Not collective.
void meetContinuum(World& world, StepTools& tools, double dt);

}  // namespace thaw
