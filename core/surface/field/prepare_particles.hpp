// SPDX-License-Identifier: Apache-2.0
// Particle fields at current positions for surfels: colours, liquid fraction, temperature.
#pragma once
#include "core/halo/surface_halos.hpp"
#include "core/scene/scene.hpp"
#include "core/surface/data/surface.hpp"

namespace thaw {

struct SurfaceTools;

/// Migrates the particle copies to the ranks that own their cells, without ghosts. Results of
/// prepareParticles become invalid. Collective.
void placeParticles(Surface& surface, SurfaceHalos halos, SurfaceTools& tools);

/// Computes ghosts and bins of the particles, and the colour field of its own component at each particle. The
/// field is smoothed once and twice (level_table.hpp), and is 1 inside a lattice. Does nothing if
/// tools.relax.particlesPrepared is set. Requires: placed particles. Collective.
void prepareParticles(const Scene& scene, Surface& surface, SurfaceHalos halos, SurfaceTools& tools);

/// Samples liquid fraction and temperature at owned surfels: means over their component's particles within
/// h_ps, with weights (1 - (r/h_ps)^2)^3. Without such particles, values do not change. Requires: placed
/// particles and surfels. Collective unless prepareParticles was called.
void sampleFields(const Scene& scene, Surface& surface, SurfaceHalos halos, SurfaceTools& tools);

}  // namespace thaw
