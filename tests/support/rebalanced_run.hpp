// SPDX-License-Identifier: Apache-2.0
// Runs on the ranks of a group with partitions that change, for comparison with a run on one rank.
#pragma once
#include <gtest/gtest.h>

#include <bit>

#include "core/math/hash_random.hpp"
#include "core/simulation/body_types/cell_costs.hpp"
#include "parallel/bond_halo.hpp"
#include "parallel/cell_halo.hpp"
#include "tests/support/simulation.hpp"

namespace thaw::test {

/// Adds the bits of a value to a hash.
inline std::uint64_t mixed(std::uint64_t h, double x) { return mixBits(h + std::bit_cast<std::uint64_t>(x)); }

/// Runs `steps` steps with a new partition every 20 steps, calls each(world) after each of them, and returns
/// end(world, all).
template<class Each, class End>
auto runRebalanced(MPI_Comm group, const Scene& scene, int steps, Each each, End end) {
  const Communicator comm(group);
  MpiReducer all(comm);
  World w;
  w.scene = scene;
  StepTools tools;
  prepareWorld(w, tools, {});
  MpiCellHalo cells(comm, w.grid);
  MpiBondHalo bonds(comm);
  const Halos halos{all, cells, bonds};
  startWorld(w, halos, tools, {});
  for (int k = 0; k < steps; k++) {
    if (k % 20 == 15) {
      const CellCosts costs = countCells(w);
      tools.newPartition = cells.rebalance(costs.cells, costs.cost, true);
    }
    if (!step(w, halos, tools, {}).finite) {
      ADD_FAILURE() << "step " << k << " is not finite";
      break;
    }
    each(w);
  }
  return end(w, all);
}

}  // namespace thaw::test
