// SPDX-License-Identifier: Apache-2.0
// Density by continuity, and particle shifting. The density sums advance the carried densities
// (terms/carried_density.hpp, terms/carry.hpp); here is what comes before and after them.
#pragma once
#include "core/fluid/pair_sums/carry.hpp"
#include "core/simulation/workspace/step_tools.hpp"
#include "core/simulation/world/world.hpp"

namespace thaw {

/// Before the density sums of a step of dt (s; 0: at the start, when only free surface, shifting and gradient
/// correction change). Requires: wall contacts.
void beginCarry(World& world, StepTools& tools, double dt);

struct CarryContext {
  const World& world;
  StepTools& tools;
  double dt;  ///< s
};
/// Input and output for the density sums; it refers to the context.
CarryStep carryStepOf(World& world, const CarryContext& context);

/// Ends the step of carried densities after the density sums: resets particles without liquid nearby, and
/// stores the summed densities that later checks need.
void finishCarry(World& world, StepTools& tools, double dt);

/// Sets shifting velocities with summed densities: inside the liquid, down the concentration gradient. At a
/// free surface, where the gradient is along its normal, they are zero.
void shiftInside(World& world, const StepTools& tools);

}  // namespace thaw
