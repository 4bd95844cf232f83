// SPDX-License-Identifier: Apache-2.0
// Fast projection of distant surfels onto the surface.
#pragma once
#include "core/halo/surface_halos.hpp"
#include "core/surface/data/surface_view.hpp"

namespace thaw {

struct SurfaceTools;

/// Projects surfels that stopped at the margin (stoppedAtMargin), far from the surface, along the gradient of
/// the colour field. With forces, a new search would be needed for each margin of the distance. Partly molten
/// surfaces have many such surfels, because blendSurfels keeps only the liquid fraction of each update's
/// motion. Surfels below a gap are left to the forces. Afterwards, surfels have no order and no ghosts.
/// Collective.
void projectDistantSurfels(const SurfaceView& view, SurfaceHalos halos, SurfaceTools& tools);

}  // namespace thaw
