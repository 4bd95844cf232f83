// SPDX-License-Identifier: Apache-2.0
// One step of a run and its output: surface, frames, ledger, snapshots, checkpoints, balance.
#pragma once
#include "io/run/run_state.hpp"
#include "parallel/balance.hpp"

namespace thaw {

enum class Advance {
  Stepped,
  RolledBack,  ///< the step failed; the run is back at the last snapshot, with a shorter step
  Stopped,     ///< a stop was requested; the last step is complete
  BlewUp       ///< the step failed, and the retries are used up
};

/// Data that pass from one step of a run to the next.
struct StepLoop {
  StopMonitor stop;
  WorkMeter meter;
  std::string why;  ///< reason of Advance::Stopped and BlewUp
};

/// Takes one step. Requires: openRun returned Opened::Ready, and the end is not reached. Collective.
Advance advance(Run& run, StepLoop& loop);

}  // namespace thaw
