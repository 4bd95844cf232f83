// The short way onto the surface for surfels that are far from it.
#pragma once
#include "core/halo/surface_halos.hpp"
#include "core/world.hpp"

namespace thaw {

struct SurfaceTools;

/// Surfels that wait for a search (heldAtMargin) and are far from the surface go there at once, along the
/// gradient of the colour field; the forces would take them there by a margin a search. Between solid and
/// liquid there are many of them, because of the way of an update they keep but their liquid share
/// (blendSurfels). Those across a gap stay, and go on by forces. Surfels have no order and no ghosts
/// afterwards. Collective.
void leapOntoSurface(World& world, SurfaceHalos halos, SurfaceTools& tools);

}  // namespace thaw
