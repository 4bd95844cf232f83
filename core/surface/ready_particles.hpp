// What surfels ask of the particles where they are now: colours, liquid fraction, temperature.
#pragma once
#include "core/halo/surface_halos.hpp"
#include "core/world.hpp"

namespace thaw {

struct SurfaceTools;

/// The surface's copies of particles on the ranks that own their cells, without ghosts: what readyParticles
/// found of them is stale. Collective.
void placeParticles(World& world, SurfaceHalos halos, SurfaceTools& tools);

/// Ghosts of the particles, their bins, and the colour field of their own component at each, once and twice
/// smoothed (level_table.hpp), 1 in the middle of the lattice. Does nothing where tools.relax.particlesReady
/// says that it is done. Needs particles placed. Collective.
void readyParticles(World& world, SurfaceHalos halos, SurfaceTools& tools);

/// Liquid fraction and temperature of the owned surfels: means of the particles of their component within
/// h_ps with the same weight; kept where there are none. Needs readyParticles and placed surfels. Collective
/// if readyParticles is to be called.
void sampleFields(World& world, SurfaceHalos halos, SurfaceTools& tools);

}  // namespace thaw
