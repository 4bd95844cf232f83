// SPDX-License-Identifier: Apache-2.0
// Frames of oriented bodies and sheets. The functions do nothing in a scene without them.
#pragma once
#include "io/run/run_state.hpp"

namespace thaw {

/// Writes the frame of each body type, and its line in the index. Collective.
void writeBodyTypeFrames(Run& run);

/// Restores the indices at a restart. Frames after the checkpoint are dropped from them and written again.
/// Collective.
void resumeBodyTypeFrames(Run& run);

/// Removes frames after the snapshot, at a rollback. First rank only.
void removeBodyTypeFrames(Run& run);

}  // namespace thaw
