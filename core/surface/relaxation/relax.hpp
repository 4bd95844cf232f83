// SPDX-License-Identifier: Apache-2.0
// Iterations of a surface update: surfels relax under the four forces of K05 4.2.2, with the constraints of
// 4.2.3.
#pragma once
#include "core/halo/surface_halos.hpp"
#include "core/surface/data/surface_view.hpp"

namespace thaw {

struct SurfaceTools;

/// Weights k of the four forces (1; see SurfaceSettings).
struct ForceWeights {
  double implicit = 1, attract = 0, smooth = 0, repel = 0;
};
inline ForceWeights forceWeights(const SurfaceSettings& s) {
  return {s.implicit, s.attract, s.smooth, s.repel};
}

/// Result of the iterations, the same on all ranks.
struct RelaxationResult {
  std::int64_t iterations = 0;
  bool finished = false;  ///< all surfels are at rest
};

/// Relaxes the surfels by at most `iterations` steps of the forces, until no surfel moves more than
/// settings.stop of its radius. With `all`, every surfel is free (initial grown surfaces). Otherwise, only
/// surfels with liquid > 0 are free, and none without that field. Makes ghosts and lists. Surfels may be in
/// any order and anywhere in the domain, since they are placed (placeRows) and sorted at the start. At the
/// end, they have no ghosts, and have the order and ranks of the last search. Requires: particles at current
/// positions on the ranks of their cells (placeRows), with components. Collective.
RelaxationResult relaxSurfels(const SurfaceView& view, SurfaceHalos halos, SurfaceTools& tools,
                              const ForceWeights& weights, std::int64_t iterations, bool all);

}  // namespace thaw
