// Copies of the particles for a surface update, and what goes back to them.
#pragma once
#include "core/halo/surface_halos.hpp"
#include "core/world.hpp"

namespace thaw {

/// Copies of this rank's particles, unsorted, where they were at the last update, with their displacement
/// since (the shortest way round periodic sides). Fresh particles are where they are. Not collective.
void gatherParticles(World& world, int rank);

/// What was around a particle at the start is less and less so as liquid deforms: the copies' fill goes to 1
/// by e for each .3 of strain. Kept for ever it would roughen the surface of a splash. Needs the gradients of
/// the displacement.
void fadeFill(SurfaceParticles& particles);

/// Continuum::surfaceShare of what has melted of a body that was sampled from its shape: 1, its own volume,
/// from then on. Before the particles are gathered for an update.
void settleShares(World& world);

/// Sends the components (and what is left of the fills) of the copies to the particles and takes their
/// positions as those of the last update; drops the copies. Collective.
void returnParticles(World& world, SurfaceHalos halos);

}  // namespace thaw
