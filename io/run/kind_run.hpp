// Frames of the further kinds in a run; nothing where the scene has none.
#pragma once
#include "io/run/run_state.hpp"

namespace thaw {

/// The frame that is being written, of every kind, and its line in the kind's index. Collective.
void writeKindFrames(Run& run);

/// Indices of a run that goes on from a checkpoint: what was written after it goes out of them, and is
/// written again. Collective.
void resumeKindFrames(Run& run);

/// After a retry: frames of after the good state. First rank only.
void forgetKindFrames(Run& run);

}  // namespace thaw
