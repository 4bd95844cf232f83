// The iterations of a surface update: surfels settle under the four forces of K05 4.2.2, with the constraints
// of 4.2.3.
#pragma once
#include "core/halo/surface_halos.hpp"
#include "core/world.hpp"

namespace thaw {

struct SurfaceTools;

/// Weights k of the four forces, 1 (SurfaceSettings says what they are).
struct ForceWeights {
  double implicit = 1, attract = 0, smooth = 0, repel = 0;
};
inline ForceWeights forceWeights(const SurfaceSettings& s) {
  return {s.implicit, s.attract, s.smooth, s.repel};
}

/// What a call of settle has done; the same on all ranks.
struct Settled {
  std::int64_t iterations = 0;
  bool finished = false;  ///< no surfel moves any more
};

/// Moves the surfels by at most `iterations` of the forces until none moves more than settings.stop of its
/// radius. `all`: every surfel is free (at the start, for grown surfaces); else those with liquid > 0, if
/// `liquid` is a field, and none without it. Needs the particles of the surface where they are now, on the
/// ranks of their cells (placeRows), with their components; ghosts and lists are made here. Surfels may be in
/// any order and anywhere in the domain: they are placed (placeRows) at the start, and so are sorted and on
/// the right ranks, but for what they moved since the last search, at the end, when they have no ghosts.
/// Collective.
Settled settle(World& world, SurfaceHalos halos, SurfaceTools& tools, const ForceWeights& weights,
               std::int64_t iterations, bool all);

}  // namespace thaw
