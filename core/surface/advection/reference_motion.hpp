// SPDX-License-Identifier: Apache-2.0
// Moves surfels of solids by their reference positions. Incremental motion alone would drift off oscillating
// particles.
#pragma once
#include "core/particles/continuum.hpp"
#include "core/scene/scene.hpp"
#include "core/surface/data/surface.hpp"
#include "core/surface/search/bins.hpp"

namespace thaw {

/// Records reference positions and frames at the end of startSurface. Requires: particle copies; surfels at
/// their initial positions.
void recordReference(Continuum& particles, Surface& surface);

/// Moves owned surfels with a reference: sets `carried` (m, relative to the current position) and the frame.
/// The affine map from reference to current positions of the particles is fitted by moving least squares.
/// Only particles within referenceReach of the surfel in the reference count. Particles that were distant in
/// the reference do not influence a surfel, even if they are close now. A surfel loses its reference when it
/// melts or relaxes (Surfels::relaxesOnce), or if one of the particles is exposed (Solids::exposed). With
/// fewer than three particles, or with collinear particles, it moves incrementally. Requires: particle copies
/// with ghosts of referencePosition and covered, in bins at their previous positions; `carried`.
void moveByReference(const Scene& scene, Surface& surface, const Bins& particleBins);

/// Radius in the reference, in particle spacings.
inline constexpr double referenceReach = 1.9;

inline bool hasReference(const Surfels& s, std::size_t i) {
  return s.hasReference.active && s.hasReference[i];
}

}  // namespace thaw
