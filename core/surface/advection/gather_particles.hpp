// SPDX-License-Identifier: Apache-2.0
// Particle copies for a surface update, and their results returned to the particles.
#pragma once
#include "core/halo/surface_halos.hpp"
#include "core/surface/data/surface_view.hpp"

namespace thaw {

/// Copies this rank's particles, unsorted, at their positions in the last update, with their displacement
/// since then (minimum image across periodic sides). New particles have their current positions. Not
/// collective.
void gatherParticles(const SurfaceView& view, int rank);

/// Fades the effect of particles' initial surroundings as liquid deforms. The deviation of `fill` from 1 in
/// the copies decreases by a factor e per strain of 0.3. Without this, `fill` would roughen the surface of a
/// splash. Requires: displacement gradients.
void fadeFill(SurfaceParticles& particles);

/// Sets Continuum::surfaceVolumeRatio to 1 for molten particles of shape-sampled bodies. Call it before
/// particles are gathered for an update.
void resetMeltedShares(const Scene& scene, Continuum& particles);

/// Returns components (and fills) of the copies to the particles, records current positions as those of the
/// last update, and drops the copies. Collective.
void returnParticles(Continuum& particles, Solids& solids, Surface& surface, SurfaceHalos halos);

}  // namespace thaw
