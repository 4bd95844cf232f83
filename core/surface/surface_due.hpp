// SPDX-License-Identifier: Apache-2.0
// Schedule of surface updates: at every frame, after a number of steps, or after a given motion. It is the
// same on all ranks.
#pragma once
#include "core/neighbours/grid.hpp"
#include "core/particles/continuum.hpp"
#include "core/scene/scene.hpp"
#include "core/surface/data/surface.hpp"
#include "core/time/clock.hpp"

namespace thaw {

/// Returns the squared largest distance (m^2) between a particle of this rank and its position at the last
/// update, by minimum images. New particles are excluded, as are small drops, whose surface is rebuilt in
/// each update. Not collective: the time-step reduction takes the maximum over ranks.
double largestSurfaceMove2(const CellGrid& grid, const Continuum& particles, const Surface& surface);

/// Returns whether an update is due after a step. move2: m^2, largestSurfaceMove2 over all ranks. The caller
/// handles frames.
/// Requires: the surface module.
bool surfaceDue(const Scene& scene, const Clock& clock, const CellGrid& grid, const Surface& surface,
                double move2);

}  // namespace thaw
