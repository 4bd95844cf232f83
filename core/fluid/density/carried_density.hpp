// SPDX-License-Identifier: Apache-2.0
// Density by continuity, and particle shifting, from the sums of terms/carried_density.hpp.
#pragma once
#include "core/simulation/workspace/step_tools.hpp"
#include "core/simulation/world/world.hpp"

namespace thaw {

/// Compares the summed relative density (walls included) with the carried one, advances the latter by dt (s)
/// and stores it in its place; sets the shifting velocity. dt 0: only the shifting velocity. Records the
/// compression energy that diffusion changes, and counts particles much denser than their carried density.
void carryDensity(World& world, const StepTools& tools, double dt);

}  // namespace thaw
