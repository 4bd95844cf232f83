// The surface in a run: when it begins, goes on and is written. All functions but forgetSurfaceFrames are
// collective; all need the module.
#pragma once
#include "io/run/run_state.hpp"

namespace thaw {

/// The first surface, of the bodies that were sampled, and its logs.
void beginSurface(Run& run, const MeshLoader& load);

/// Index and logs of a run that goes on from a checkpoint: what was written after it goes out of them, and is
/// written again.
void resumeSurfaceOutput(Run& run);

/// One update, timed.
void updateSurfaceOf(Run& run);

/// The surface at the frame that is being written: its frame, its line in the series, and those of its
/// components in the log.
void writeSurfaceFrameOf(Run& run);

/// After a retry: frames, lines and events of after the good state. First rank only.
void forgetSurfaceFrames(Run& run);

/// Surfels, components, events, counters and times into the summary; nothing without a surface.
void gatherSurface(Run& run);

}  // namespace thaw
