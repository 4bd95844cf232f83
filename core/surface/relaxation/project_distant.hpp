// SPDX-License-Identifier: Apache-2.0
// Fast projection of distant surfels onto the surface.
#pragma once
#include "core/halo/surface_halos.hpp"
#include "core/surface/data/surface_view.hpp"

namespace thaw {

struct SurfaceTools;

/// Projects surfels that stopped at the margin (stoppedAtMargin), far from the surface, along the gradient of
/// the colour field. Forces would need a new search for each margin of the distance. Partly molten surfaces
/// have many such surfels, because blendSurfels keeps only the liquid share of each update's motion. Surfels
/// below a gap are left to the forces. Surfels have no order and no ghosts afterwards. Collective.
void projectDistantSurfels(const SurfaceView& view, SurfaceHalos halos, SurfaceTools& tools);

}  // namespace thaw
