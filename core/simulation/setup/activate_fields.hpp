// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "core/simulation/workspace/step_tools.hpp"

#include "core/simulation/world/world.hpp"

namespace thaw {

/// Activates the fields of particles and solids that the scene's modules need.
void activateFields(World& world, StepTools& tools);

}  // namespace thaw
