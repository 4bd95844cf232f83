// SPDX-License-Identifier: Apache-2.0
// Start of a run, from its scene up to its first step, and end of a run after its last step. All functions
// are collective.
#pragma once
#include "io/run/run_state.hpp"

namespace thaw {

enum class Opened {
  Ready,
  NothingLeft,         ///< the checkpoint is at the end already; the folder is unchanged
  StoppedInRelaxation  ///< a stop request came before the start; nothing is written
};

/// Prepares a run of the scene: folder, memory, particles or checkpoint, first frame, snapshot, summary.
/// Throws SceneErrors, ShapeError, IoError or std::runtime_error (one sentence), alike on all ranks.
Opened openRun(Run& run, Scene scene);

/// Ends a run after its last step. code: exitDone, exitStopped or exitBlewUp; `why` gives the reason of the
/// latter two. Writes the last checkpoint, unless the run failed, and the summary. Returns the exit code.
int finishRun(Run& run, int code, std::string why);

}  // namespace thaw
