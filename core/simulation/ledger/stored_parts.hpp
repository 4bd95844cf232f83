// SPDX-License-Identifier: Apache-2.0
// Parts of the potential energy in a ledger.
#pragma once
#include "core/halo/halo.hpp"
#include "core/simulation/world/world.hpp"

namespace thaw {

struct StepTools;

/// Energies (J) that sum up to Balance::potential.
struct StoredParts {
  double gravity = 0;      ///< all particles
  double compression = 0;  ///< liquids
  double tension = 0;      ///< liquids: surface tension, and compressed contacts
  double contact = 0;      ///< solids: compressed contacts
};

/// Requires: forces were evaluated at the current positions, as after a step and at the start, but not right
/// after a restart. Ensures: the same bits on any number of ranks. Collective.
StoredParts storedParts(World& world, const StepTools& tools, Reducer& all);

}  // namespace thaw
