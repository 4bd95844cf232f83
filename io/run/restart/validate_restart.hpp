// SPDX-License-Identifier: Apache-2.0
// Validation of a checkpoint against the scene that continues it. It does not rely on the restart record,
// since rows index lists of the scene.
#pragma once
#include <string>
#include <vector>

#include "core/halo/halo.hpp"
#include "core/simulation/world/world.hpp"

namespace thaw {

/// Returns a line for each kind of row that the scene lacks, counted over all ranks; the same on all ranks.
/// Requires: restoreWorld, and the modules and sheets of the scene. Collective.
std::vector<std::string> checkpointMismatches(const World& world, Reducer& all);

}  // namespace thaw
