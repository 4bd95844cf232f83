// SPDX-License-Identifier: Apache-2.0
// Energy that leaves through open sides with liquids that have surface tension. Surface and compression
// energy depend on neighbours. Removal of a particle exposes its neighbours and lowers their density, which
// changes their energy.
#pragma once
#include <vector>

#include "core/halo/halo.hpp"
#include "core/ledger/leaver.hpp"
#include "core/simulation/world/world.hpp"

namespace thaw {

struct StepTools;

/// Returns the leavers of all ranks, ascending by id. Collective.
std::vector<Leaver> leaversOfAll(const World& world, const StepTools& tools, Reducer& all);

/// Adds to Ledger::left the energy that owned liquid particles lose when RedistributionWork::leavers are
/// removed. It is negative where they gain energy. Requires: up-to-date cells, positions, densities and
/// surface sums of the remaining particles.
void recordEnergyLeft(World& world, const StepTools& tools);

}  // namespace thaw
