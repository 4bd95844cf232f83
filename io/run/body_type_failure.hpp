// SPDX-License-Identifier: Apache-2.0
// The oriented particle or vertex that made a step fail.
#pragma once
#include <string>

#include "core/simulation/monitor/monitor.hpp"
#include "core/simulation/time/limits.hpp"
#include "core/simulation/world/world.hpp"
#include "io/run/run_state.hpp"

namespace thaw {

/// Returns the failed check and "oriented particle 17 of 'skin' at (x, y, z) m has ..." on the rank that owns
/// the row, "" on the others. Names the row whose position or velocity is not finite. In scenes without
/// continuum, or if the body type limits the step, it names the fastest row. Returns "" if no row failed.
/// Collective; the same row on any number of ranks.
std::string bodyTypeFailure(const World& world, const StepTools& tools, const StepOutcome& failed,
                            Reducer& all);

}  // namespace thaw
