// Oriented particles that have come into an obstacle, or into a solid, where contact holds them no more on
// one side of it.
#pragma once
#include "core/step.hpp"

namespace thaw {

/// Of an oriented body and a body of the continuum.
struct Sunken {
  std::size_t oriented = 0, body = 0;
  std::int64_t count = 0;  ///< particles of the first, of all ranks
};

/// Oriented particles as deep in a solid as its outermost particles: those of one body that are solid fill
/// more than .7 of the kernel around them (.5 at its surface, .3 or less where contact holds them off). Where
/// a solid goes through a surface, particles of the surface are in it meanwhile. The same on any number of
/// ranks. Needs a world between two steps, with the ghosts of the last one; sends their phase again.
/// Collective.
std::vector<Sunken> findSunken(World& world, Halos halos);

/// Free oriented particles more than a quarter of their spacing inside an obstacle (`body`: its number among
/// the walls): drawn into it, or there from the start. Collective.
std::vector<Sunken> findSunkenInObstacles(const World& world, Reducer& all);

}  // namespace thaw
