// A surface that was read from a checkpoint, or brought back from the last good state, made ready; and its
// cut over the ranks.
#pragma once
#include "core/surface/update_surface.hpp"

namespace thaw {

/// Sorts surfels that came in any order and cuts the domain by them; they go to their ranks at the next
/// update. Collective.
void resumeSurface(World& world, SurfaceHalos halos, SurfaceTools& tools);

/// Lets the halo decide whether to cut anew, by counted work: an update costs about the same for each surfel.
/// Counts and not times, since an update is too rare for means of measured time. Between updates; force: cut
/// in any case. Collective.
void balanceSurface(World& world, SurfaceHalos halos, SurfaceTools& tools, bool force);

/// The first cut, before there are surfels: by particle copies that were gathered and are not placed yet.
/// Collective.
void cutByParticles(World& world, SurfaceHalos halos, SurfaceTools& tools);

/// Empties surfels, components, events and all else that is state; radii and grid stay.
void emptySurface(Surface& surface);

}  // namespace thaw
