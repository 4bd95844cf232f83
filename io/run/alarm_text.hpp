// An alarm of the watch, in words.
#pragma once
#include <string>

#include "core/watch/suspect.hpp"
#include "io/run/run_state.hpp"

namespace thaw {

/// "speed of 12.3 m/s (the scene makes 2.8 m/s, numerics.watch_speed allows 31 m/s): particle 17 of body
/// 'cube' at (x, y, z) m has ..., forces: ...". On the rank that owns the suspect. Forces are summed anew
/// (force_shares.hpp).
std::string alarmText(World& world, StepTools& tools, const StepOutcome& failed, const Suspect& suspect);

/// What the watch saw, and which bound it is beyond, without the particle that it may be seen at.
std::string exceeded(const World& world, const StepTools& tools, const StepOutcome& failed);

/// The text of the one rank where it is not empty, on all. Collective.
std::string fromOwner(const Communicator& comm, const std::string& text);

}  // namespace thaw
