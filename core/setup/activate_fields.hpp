#pragma once
#include "core/step.hpp"

namespace thaw {

/// Switches on the fields of particles and solids that the scene's modules need, and no others.
void activateFields(World& world, StepTools& tools);

}  // namespace thaw
