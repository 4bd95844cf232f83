// Load balance by measured time.
#pragma once
#include "core/step.hpp"

namespace thaw {

/// Remembers how much work a rank had done at the last look.
struct WorkMeter { double seconds = 0, kinds[2] = {0, 0}; };

/// Seconds of work on the continuum (not of waiting or output) so far.
double workOf(const PhaseTimes& times);

/// Gives cells a cost of this rank's time per particle since the last call and lets the halo decide whether to cut anew. Particles move at
/// the next evaluation. Collective.
bool balance(World& world, CellHalo& halo, StepTools& tools, WorkMeter& meter);

}  // namespace thaw
