// Which row of a further kind of body (oriented particle, vertex of a sheet) is what went wrong.
#pragma once
#include <string>

#include "core/time/limits.hpp"
#include "core/watch/watch.hpp"
#include "core/world.hpp"
#include "io/run/run_state.hpp"

namespace thaw {

/// What was exceeded, and "oriented particle 17 of 'skin' at (x, y, z) m has ...", of the one whose place or
/// velocity is not finite; where there is no continuum, or the step's limit is that of the kind, else the
/// fastest one. On the rank that owns it; empty on the others, and where no kind is to blame. Collective; the
/// same row on any number of ranks.
std::string kindSuspect(const World& world, const StepTools& tools, const StepOutcome& failed, Reducer& all);

}  // namespace thaw
