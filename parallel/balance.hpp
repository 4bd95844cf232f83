// SPDX-License-Identifier: Apache-2.0
// Load balance by measured time.
#pragma once
#include "core/simulation/workspace/step_tools.hpp"
#include "core/simulation/world/world.hpp"

namespace thaw {

/// Work of each phase on a rank at the last measurement.
struct WorkMeter {
  std::array<double, stepPhases> seconds{};
};

/// Seconds of work on the continuum so far, without waiting and output.
double workOf(const PhaseTimes& times);

/// Assigns cells the cost of their liquid and solid particles, from this rank's times since the last call.
/// The halo then makes a new partition if it reduces the imbalance enough. Particles migrate at the next
/// evaluation. Returns whether a new partition is pending. Collective.
bool balance(World& world, CellHalo& halo, StepTools& tools, WorkMeter& meter);

}  // namespace thaw
