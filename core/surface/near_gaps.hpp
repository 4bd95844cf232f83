// Solids with sheets that are near to each other, told by their particles: where surfaces are first grown
// there are no surfels yet that face each other (docs/validation/stability.md B22).
#pragma once
#include <cstdint>
#include <vector>

#include "core/halo/halo.hpp"
#include "core/surface/bins.hpp"
#include "core/world.hpp"

namespace thaw {

/// Labels, ascending: of components with a solid or a liquid particle across a gap from another of theirs.
struct NearGaps {
  std::vector<std::uint64_t> solid, liquid;
};

/// Sheets nearer to each other than the colour field is wide are one lump to it. A particle, of a body whose
/// surface is grown, is across a gap from another one of its component within h_ps that lies behind an empty
/// place, if the way to it from particle to particle, none farther apart than neighbours of a lattice are, is
/// half as long again as the straight one, or there is none so near. Needs the particles' colours, bins and
/// ghosts (readyParticles). Collective.
NearGaps findNearGaps(const World& world, const Bins& particleBins, Reducer& all);

}  // namespace thaw
