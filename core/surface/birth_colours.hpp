// Colours of surfels that are grown from particles.
#pragma once
#include <vector>

#include "core/halo/surface_halos.hpp"
#include "core/surface/bins.hpp"
#include "core/surface/births.hpp"
#include "core/world.hpp"

namespace thaw {

struct SurfaceTools;

/// Has some body a mesh, which may have colours at its vertices, or are there materials of different colours?
bool coloursMayDiffer(const Scene& scene);

/// New surfels around a particle (SurfelRow::particle) get the mean colour of the surfels of their component
/// within two spacings, so that where liquids of two colours have run into each other there are no specks.
/// Without one there, those of a body without a mesh keep that of their material; of a body with a mesh they
/// get that of the nearest surfel of their component among those within a cell's edge of the particle, of
/// several the one with the smaller id; where there is none of it, as on a drop that has just come off, of
/// any. Needs bins of the surfels, with ghosts.
void inheritColours(const World& world, const Bins& bins, std::vector<SurfelRow>& rows);

/// The same for placed surfels without ghosts. Scenes of one colour pay nothing. Collective.
void inheritColours(World& world, SurfaceHalos halos, SurfaceTools& tools, std::vector<SurfelRow>& rows);

}  // namespace thaw
