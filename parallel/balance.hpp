// Load balance by measured time.
#pragma once
#include "core/step.hpp"

namespace thaw {

/// Remembers how much work of each phase a rank had done at the last look.
struct WorkMeter {
  std::array<double, stepPhases> seconds{};
};

/// Seconds of work on the continuum (not of waiting or output) so far.
double workOf(const PhaseTimes& times);

/// Gives cells the cost of their liquid and solid particles, by this rank's times of each since the last
/// call, and lets the halo decide whether to cut anew. Particles move at the next evaluation. Collective.
bool balance(World& world, CellHalo& halo, StepTools& tools, WorkMeter& meter);

}  // namespace thaw
