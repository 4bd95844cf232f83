// SPDX-License-Identifier: Apache-2.0
// Grows surfaces around particles without surfels: bodies that are not sampled, separated drops, and new
// particles of emitters (K05 4.3).
#pragma once
#include <functional>

#include "core/halo/surface_halos.hpp"
#include "core/surface/data/surface_view.hpp"

namespace thaw {

struct SurfaceTools;

/// Grows surfels around the owned particle copies selected by exposed(row). Seeds in all directions around
/// each particle are projected onto the iso-surface of their component's colour field. Seeds that end far
/// from their particle are dropped, so inner particles have none. No forces act. The surface is oversampled
/// until resample thins it. Requires: placed particles. Afterwards, surfels have no valid cells. Collective.
void growSurfels(const SurfaceView& view, SurfaceHalos halos, SurfaceTools& tools,
                 const std::function<bool(std::size_t)>& exposed);

/// Grows the initial surfaces of all bodies that are not sampled (isSampled). Surfels relax first by the
/// implicit force only, then, after resampling, by the scene's forces. Requires: no surfels. Collective.
void growBodies(const SurfaceView& view, SurfaceHalos halos, SurfaceTools& tools);

/// Renews surfels before the iterations of an update. Components without surfels get new ones. Components of
/// at most smallDrop particles get a sphere of the particles' volume around their centroid. Surfels deep
/// inside their own component (former caps of a stream, sheets in contact) or far off it are deleted.
/// Requires: Surface::components of the last update. Collective.
void renewSurfels(const SurfaceView& view, SurfaceHalos halos, SurfaceTools& tools);

/// Resamples, with births beyond borders where the particles' surface continues. Collective.
void resampleOnParticles(const SurfaceView& view, SurfaceHalos halos, SurfaceTools& tools,
                         std::int64_t rounds);

}  // namespace thaw
