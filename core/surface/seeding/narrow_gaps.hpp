// SPDX-License-Identifier: Apache-2.0
// Detects narrow gaps between sheets by particles, since no surfels exist before surfaces are grown
// (docs/validation/stability.md, row 22).
#pragma once
#include <cstdint>
#include <vector>

#include "core/halo/halo.hpp"
#include "core/scene/scene.hpp"
#include "core/surface/data/surface.hpp"
#include "core/surface/search/bins.hpp"

namespace thaw {

/// Labels, ascending, of components with a gap between two of their solid or liquid particles.
struct NarrowGaps {
  std::vector<std::uint64_t> solid, liquid;
};

/// Finds components with narrow gaps, which the colour field would merge. Only bodies with grown surfaces are
/// tested. Two particles of a component within h_ps, across an empty lattice site, may have a gap. They have
/// a gap if no path shorter than 1.5 times their distance connects them. Steps of a path are at most the
/// distance of lattice neighbours. Requires: particle colours, bins and ghosts (prepareParticles).
/// Collective.
NarrowGaps findNarrowGaps(const Scene& scene, const Surface& surface, const Bins& particleBins, Reducer& all);

}  // namespace thaw
