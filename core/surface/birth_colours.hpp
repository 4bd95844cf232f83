// Colours of surfels that are grown from particles.
#pragma once
#include <vector>

#include "core/halo/surface_halos.hpp"
#include "core/surface/bins.hpp"
#include "core/surface/births.hpp"
#include "core/world.hpp"

namespace thaw {

struct SurfaceTools;

/// Does some body of the scene have a mesh, whose colours are to be inherited?
bool hasMeshes(const Scene& scene);

/// New surfels around a particle (SurfelRow::particle) of a body with a mesh, which may have had a colour at each vertex, get that of the nearest surfel of
/// their component among those within a cell's edge of the particle, of several the one with the smaller id; where there is none of it, as on a drop
/// that has just come off, of any. Without one in reach they keep that of their material. Needs bins of the surfels, with ghosts.
void inheritColours(const World& world, const Bins& bins, std::vector<SurfelRow>& rows);

/// The same for placed surfels without ghosts. Scenes without meshes pay nothing. Collective.
void inheritColours(World& world, SurfaceHalos halos, SurfaceTools& tools, std::vector<SurfelRow>& rows);

}  // namespace thaw
