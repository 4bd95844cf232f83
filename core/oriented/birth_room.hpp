// Where no particle of a surface is made: in obstacles, and in solids.
#pragma once
#include "core/step.hpp"

namespace thaw {

/// A place at which a particle of an oriented body is to be made.
struct BirthPlace {
  std::size_t body = 0;
  Vec3d place{};
  double apart = 0;  ///< m, from obstacles, at least
};

/// For each of this rank's places: is it in an obstacle, or too near to one, or below the surface of a
/// continuum body that is solid there? The places of all ranks go round, since particles of bodies are where
/// their own cells are (while surfaces relax before the start, not even there): so the answer is the same on
/// any number of ranks. Needs walls as they are now and the cells of owned particles. Collective.
std::vector<char> takenPlaces(const World& world, const std::vector<BirthPlace>& places, Reducer& all);

}  // namespace thaw
