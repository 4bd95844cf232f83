// The oriented bodies' part of a step.
#pragma once
#include "core/step.hpp"

namespace thaw {

/// Carries all oriented particles over dt (s). Needs them at home. Collective.
void stepOriented(World& world, Halos halos, StepTools& tools, double dt);

/// The longest step (s) that is stable for this rank's particles; `never` without any. To be reduced over ranks.
double orientedStepLimit(const World& world);

}  // namespace thaw
