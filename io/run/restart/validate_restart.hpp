// SPDX-License-Identifier: Apache-2.0
// Validation of a checkpoint against the scene that continues it. Rows contain indices into lists of the
// scene. They are checked directly, without the restart record.
#pragma once
#include <string>
#include <vector>

#include "core/halo/halo.hpp"
#include "core/simulation/world/world.hpp"

namespace thaw {

/// Returns a line for each type of row that refers to parts which the scene lacks, with their number over all
/// ranks. The result is the same on all ranks. Requires: restoreWorld, and the modules and sheets of the
/// scene. Collective.
std::vector<std::string> checkpointMismatches(const World& world, Reducer& all);

}  // namespace thaw
