// SPDX-License-Identifier: Apache-2.0
// Runs on the ranks of a group with partitions that change, for comparison with a run on one rank.
#pragma once
#include <gtest/gtest.h>

#include <bit>

#include "core/math/hash_random.hpp"
#include "core/simulation/body_types/cell_costs.hpp"
#include "parallel/mpi_simulation.hpp"
#include "tests/support/simulation.hpp"

namespace thaw::test {

/// Adds the bits of a value to a hash.
inline std::uint64_t mixed(std::uint64_t h, double x) { return mixBits(h + std::bit_cast<std::uint64_t>(x)); }

/// Runs `steps` steps with a new partition every 20 steps, calls each(world) after each of them, and returns
/// end(world, all).
template<class Each, class End>
auto runRebalanced(MPI_Comm group, const Scene& scene, int steps, Each each, End end) {
  const Communicator comm(group);
  MpiSimulation simulation(comm);
  World& w = simulation.world;
  w.scene = scene;
  simulation.prepare({});
  simulation.start({});
  for (int k = 0; k < steps; k++) {
    if (k % 20 == 15) {
      const CellCosts costs = countCells(w);
      simulation.tools.redistribution.newPartition = simulation.tables.cells->rebalance(costs.cells,
                                                                                        costs.cost, true);
    }
    if (!simulation.step().finite) {
      ADD_FAILURE() << "step " << k << " is not finite";
      break;
    }
    each(w);
  }
  return end(w, simulation.all);
}

}  // namespace thaw::test
