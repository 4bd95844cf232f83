// SPDX-License-Identifier: Apache-2.0
// Snapshot: the data of a checkpoint in memory, for this rank.
#pragma once
#include <cstddef>
#include <vector>

#include "core/simulation/monitor/packed_columns.hpp"
#include "core/simulation/workspace/step_tools.hpp"
#include "core/simulation/world/world.hpp"

namespace thaw {

struct WorldSnapshot {
  World world;  ///< only the parts that takeSnapshot fills; of the particles, only their number and their
                ///< solids
  PackedTable particles;  ///< State columns of particles: most of the memory for a fluid
};

/// Stores the data of a checkpoint: State columns of particles and solids, bonds, surface, clock, ledger,
/// counters and monitor state. Memory is reused. Requires: a world between two steps.
void takeSnapshot(const World& world, WorldSnapshot& kept);

/// Empties particles, solids, bonds and surface, and their data in tools. A state can then be restored as in
/// a restart, with new halos.
void emptyWorld(World& world, StepTools& tools);

/// Restores a snapshot into a world that emptyWorld has emptied. Returns records of the solids for the new
/// BondHalo. Then call resumeWorld (core/simulation/setup/setup.hpp), and resumeSurface if there is a
/// surface. The run continues with the same bits as from the state itself.
std::vector<std::byte> restoreSnapshot(const WorldSnapshot& kept, World& world);

}  // namespace thaw
