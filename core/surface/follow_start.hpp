// Where a surfel of what is solid is, by where it was at the start: what is carried from update to update
// alone drifts off its particles as they swing.
#pragma once
#include "core/surface/bins.hpp"
#include "core/world.hpp"

namespace thaw {

/// Keeps places and frames of the start. At the end of startSurface: particles have copies, surfels are where
/// they begin.
void keepStart(World& world);

/// For owned surfels that follow: sets `carried` (m, from where they are) and the frame by the affine map, in
/// the least squares of moving weights, that takes the particles' places of the start to those of now, over
/// particles that lay within followReach of the surfel then. Particles far from each other at the start do
/// not act on each other's surfels, however close they are now. A surfel follows no more for good as soon as
/// it melts, settles (Surfels::loose), or one of those particles is bare (Solids::bared); where fewer than
/// three of them are in reach, or they lie in a line, it is carried along for now. Needs copies with ghosts
/// of startPlace and covered, in bins at their places of the last update, and `carried`.
void followStart(World& world, const Bins& particleBins);

/// Spacings of the particles.
inline constexpr double followReach = 1.9;

inline bool follows(const Surfels& s, std::size_t i) { return s.follows.active && s.follows[i]; }

}  // namespace thaw
