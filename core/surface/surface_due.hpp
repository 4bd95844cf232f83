// SPDX-License-Identifier: Apache-2.0
// Schedule of surface updates: at every frame, every so many steps, or after a given motion. The same on all
// ranks.
#pragma once
#include "core/simulation/world/world.hpp"

namespace thaw {

/// Returns the squared largest distance (m^2) between a particle of this rank and its position at the last
/// update, by minimum images. New particles do not count, nor do small drops, whose surface is rebuilt in
/// each update. Not collective: the time-step reduction takes the maximum over ranks.
double largestSurfaceMove2(const World& world);

/// Returns whether an update is due after a step. move2 (m^2): maximum over ranks. The caller handles frames.
/// Requires: the surface module.
bool surfaceDue(const World& world, double move2);

}  // namespace thaw
