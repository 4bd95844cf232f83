// SPDX-License-Identifier: Apache-2.0
// Relaxation of oriented bodies before the first step.
#pragma once
#include "core/halo/halos.hpp"
#include "core/simulation/workspace/step_tools.hpp"
#include "core/simulation/world/world.hpp"

namespace thaw {

/// Relaxes the bodies that request it (FIRE, B06), with growth. Stops when no force exceeds
/// 1e-9 stiffness times spacing, after OrientedBody::relax iterations, when progress stalls
/// (core/oriented/data/relax_progress.hpp), or when OrientedWork::stopRelaxing returns true on a rank.
/// Ensures: velocities are those of the scene. Returns the number of iterations. Collective.
std::int64_t relaxOriented(World& world, Halos halos, StepTools& tools);

}  // namespace thaw
