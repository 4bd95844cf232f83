// Copies of the particles for a surface update, and what goes back to them.
#pragma once
#include "core/halo/surface_halos.hpp"
#include "core/world.hpp"

namespace thaw {

/// Copies of this rank's particles, unsorted, where they were at the last update, with their displacement since (the shortest way round
/// periodic sides). Fresh particles are where they are. Not collective.
void gatherParticles(World& world, int rank);

/// Sends the components of the copies to the particles and takes their positions as those of the last update; drops the copies. Collective.
void returnParticles(World& world, SurfaceHalos halos);

}  // namespace thaw
