// What the potential energy of a ledger is made of.
#pragma once
#include "core/halo/halo.hpp"
#include "core/world.hpp"

namespace thaw {

struct StepTools;

/// J. They add up to Balance::potential.
struct StoredParts {
  double gravity = 0;      ///< of everything
  double compression = 0;  ///< of liquids
  double tension = 0;      ///< of liquids: surface tension, and contacts that are pressed together
  double contact = 0;      ///< of solids: contacts that are pressed together
};

/// Requires: forces were evaluated at the places of now, as after a step and at the start; not yet so after a
/// restart. Ensures: the same bits on any number of ranks. Collective.
StoredParts storedParts(World& world, const StepTools& tools, Reducer& all);

}  // namespace thaw
