// SPDX-License-Identifier: Apache-2.0
// The parts of a scene's extensions in a world (core/domain/extensions.hpp).
#pragma once
#include "core/simulation/workspace/step_tools.hpp"
#include "core/simulation/world/world.hpp"

namespace thaw {

/// Adds loads, pair forces, fields and their updates, and step limits of the scene's extensions. Throws
/// std::runtime_error for an extension that is not registered, and for a pair force that the scene excludes.
void addExtensions(World& world, StepTools& tools);

}  // namespace thaw
