// Moves surfels of solids by their reference positions. Incremental motion alone would drift off oscillating
// particles.
#pragma once
#include "core/surface/bins.hpp"
#include "core/world.hpp"

namespace thaw {

/// Records reference positions and frames at the end of startSurface. Requires: particle copies; surfels at
/// their initial positions.
void keepStart(World& world);

/// Moves owned surfels with a reference: sets `carried` (m, relative to the current position) and the frame.
/// The affine map from reference to current positions of the particles is fitted by moving least squares.
/// Only particles within followReach of the surfel in the reference count. Particles that were distant there
/// do not influence a surfel, however close they are now. A surfel loses its reference when it melts, relaxes
/// (Surfels::loose), or if one of the particles is exposed (Solids::bared). With fewer than three particles,
/// or collinear ones, it moves incrementally. Requires: particle copies with ghosts of startPlace and
/// covered, in bins at their previous positions; `carried`.
void followStart(World& world, const Bins& particleBins);

/// Radius in the reference, in particle spacings.
inline constexpr double followReach = 1.9;

inline bool follows(const Surfels& s, std::size_t i) { return s.follows.active && s.follows[i]; }

}  // namespace thaw
