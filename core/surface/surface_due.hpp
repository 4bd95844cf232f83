// When the surface is updated: at every frame, every so many steps, or when particles have come far enough.
// The same on all ranks.
#pragma once
#include "core/world.hpp"

namespace thaw {

/// Square of the largest distance (m^2) between a particle of this rank and its place at the last update, the
/// shortest way round periodic sides. Fresh particles, which no update has seen, do not count, nor do those
/// of drops of at most smallDrop particles, whose surface comes anew in each update. Not collective: the vote
/// takes the largest of all ranks.
double largestSurfaceMove2(const World& world);

/// Is an update due after a step? move2 (m^2): of all ranks. Frames are the caller's. Needs the module.
bool surfaceDue(const World& world, double move2);

}  // namespace thaw
