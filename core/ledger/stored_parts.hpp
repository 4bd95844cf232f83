// Parts of the potential energy in a ledger.
#pragma once
#include "core/halo/halo.hpp"
#include "core/world.hpp"

namespace thaw {

struct StepTools;

/// Energies (J) that sum up to Balance::potential.
struct StoredParts {
  double gravity = 0;      ///< of all particles
  double compression = 0;  ///< of liquids
  double tension = 0;      ///< of liquids: surface tension, and compressed contacts
  double contact = 0;      ///< of solids: compressed contacts
};

/// Requires: forces were evaluated at the current positions, as after a step and at the start, but not right
/// after a restart. Ensures: the same bits on any number of ranks. Collective.
StoredParts storedParts(World& world, const StepTools& tools, Reducer& all);

}  // namespace thaw
