// SPDX-License-Identifier: Apache-2.0
// Update of the surface (K05 section 4): overview.
#pragma once
#include "core/halo/surface_halos.hpp"
#include "core/surface/data/surface_view.hpp"
#include "core/surface/work/surface_tools.hpp"

namespace thaw {

/// Makes the first surface of the bodies. Requires: Surface without surfels; particles in place. Collective.
void startSurface(const SurfaceView& view, SurfaceHalos halos, SurfaceTools& tools);

/// Moves the surfels with the particles, relaxes the surfels, and splits and merges components. The bits are
/// the same on any number of ranks. Collective.
void updateSurface(const SurfaceView& view, SurfaceHalos halos, SurfaceTools& tools);

}  // namespace thaw
