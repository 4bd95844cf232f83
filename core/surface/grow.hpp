// Surfaces where there were none: around the particles of bodies that are not sampled, of drops, of what
// emitters let out (K05 4.3).
#pragma once
#include <functional>

#include "core/halo/surface_halos.hpp"
#include "core/world.hpp"

namespace thaw {

struct SurfaceTools;

/// Surfels around the owned particle copies that `bare` (row) names: places in all directions around each,
/// moved onto the iso-surface of their component's colour field; those that do not come to lie near their
/// particle are dropped: inner particles have none. More than are needed: resample thins them. Needs placed
/// particles; surfels have no valid cells afterwards. Not more than what is said here is done: no forces.
/// Collective.
void growSurfels(World& world, SurfaceHalos halos, SurfaceTools& tools,
                 const std::function<bool(std::size_t)>& bare);

/// At the start, before there are other surfels: grows the surfaces of all particles whose body is not
/// sampled (isSampled), lets them settle by the implicit force alone and then by the scene's, with resampling
/// in between. Collective.
void growBodies(World& world, SurfaceHalos halos, SurfaceTools& tools);

/// In an update, before the iterations: components without surfels get some; the surfels of a component of at
/// most smallDrop particles become a sphere of the particles' volume around their middle; surfels deep inside
/// their own component (old caps of a stream that goes on, sheets that have met) or far off it are deleted.
/// Needs Surface::components of the last update. Collective.
void renewSurfels(World& world, SurfaceHalos halos, SurfaceTools& tools);

/// resample, with births past borders where the particles' surface is. Collective.
void resampleOnParticles(World& world, SurfaceHalos halos, SurfaceTools& tools, std::int64_t rounds);

}  // namespace thaw
