// SPDX-License-Identifier: Apache-2.0
// The surface in a run: start, update and output. All functions require the surface module. All except
// removeSurfaceFrames are collective.
#pragma once
#include "io/run/run_state.hpp"

namespace thaw {

/// Creates the first surface from the sampled bodies, and starts its logs.
void beginSurface(Run& run, const MeshLoader& load);

/// Restores index and logs at a restart. Entries after the checkpoint are dropped and written again.
void resumeSurfaceOutput(Run& run);

/// Updates the surface and measures the time.
void updateSurfaceOf(Run& run);

/// Writes the surface at the current frame: its frame, its line in the index, and its components in the log.
void writeSurfaceFrameOf(Run& run);

/// Removes frames, lines and events after the snapshot, at a rollback. First rank only.
void removeSurfaceFrames(Run& run);

/// Adds surfels, components, events, counters and times to the summary. Does nothing without a surface.
void gatherSurface(Run& run);

}  // namespace thaw
