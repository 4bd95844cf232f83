// The sheets' part of a step.
#pragma once
#include "core/step.hpp"

namespace thaw {

/// Carries all vertices over dt (s). Needs them at home. Collective.
void stepSheets(World& world, Halos halos, StepTools& tools, double dt);

/// The longest step (s) that is stable for this rank's vertices; `never` without any. To be reduced over ranks.
double sheetStepLimit(const World& world);

}  // namespace thaw
