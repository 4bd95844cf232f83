// The last good state, in memory: what a checkpoint holds, as this rank has it.
#pragma once
#include <cstddef>
#include <vector>

#include "core/step.hpp"
#include "core/watch/packed_columns.hpp"

namespace thaw {

struct GoodState {
  World world;            ///< only what keepState fills; of the particles no more than their number and slots
  PackedTable particles;  ///< their State columns: most of what a fluid keeps
};

/// Keeps the State columns of particles (and their slots) and solids, bonds, the surface, clock, ledger,
/// counters and watch: enough for a checkpoint. Needs a world between two steps. Memory is reused from one
/// time to the next.
void keepState(const World& world, GoodState& kept);

/// Empties particles, solids, bonds and surface, and what tools keep of them, so that a state can be brought
/// in as after a restart: with new halos.
void emptyWorld(World& world, StepTools& tools);

/// Takes over what keepState has kept, into a world that emptyWorld has emptied. Returns records of the
/// solids, for the new BondHalo; then resumeWorld (core/setup/setup.hpp), and resumeSurface where there is
/// one, make it ready. From there on the same bits as from the state itself.
std::vector<std::byte> bringBack(const GoodState& kept, World& world);

}  // namespace thaw
