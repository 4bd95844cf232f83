// Solids with sheets that are near to each other, told by their particles: where surfaces are first grown there are no surfels yet that face each other (accuracy.md B22).
#pragma once
#include <cstdint>
#include <vector>

#include "core/halo/halo.hpp"
#include "core/surface/bins.hpp"
#include "core/world.hpp"

namespace thaw {

/// Sheets nearer to each other than the colour field is wide are one lump to it. Labels, ascending, of the components with a solid particle, of a body whose surface is grown, that has another one across a gap
/// within h_ps: it lies behind an empty place, and the way to it from particle to particle, none farther apart than neighbours of a lattice are, is half as long again as the straight one, or
/// there is none so near. Liquids have no gaps, since they are to close. Needs the particles' colours, bins and ghosts (readyParticles). Collective.
std::vector<std::uint64_t> componentsWithGaps(const World& world, const Bins& particleBins, Reducer& all);

}  // namespace thaw
