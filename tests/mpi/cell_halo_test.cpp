// SPDX-License-Identifier: Apache-2.0
#include "parallel/cell_halo.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>

#include "tests/support/halo_check.hpp"

using namespace thaw;
using namespace thaw::test;

namespace {

/// Checks that every cell of the grid has one owner, the same on all ranks.
void checkTiling(const CellGrid& g, const MpiCellHalo& halo, Reducer& all) {
  std::vector<std::int64_t> owners;
  const Partition partition(halo.boxes());
  Vec3i c;
  for (c.z = 0; c.z < g.cells.z; c.z++)
    for (c.y = 0; c.y < g.cells.y; c.y++)
      for (c.x = 0; c.x < g.cells.x; c.x++) {
        const bool ours = halo.owns(cellKey(c));
        owners.push_back(ours ? 1 : 0);
        const int owner = partition.owner(c, (c.x + c.y) % all.size());
        ASSERT_GE(owner, 0);
        EXPECT_EQ(owner == all.rank(), ours);
      }
  EXPECT_EQ(partition.owner({-1, 0, 0}, 0), -1);
  EXPECT_EQ(partition.owner({0, g.cells.y, 0}, 0), -1);
  all.sum(owners);
  for (const std::int64_t n : owners) ASSERT_EQ(n, 1);
}

/// Cost of the occupied owned cells, with expensive particles in one corner of the domain.
std::vector<double> costs(const HaloRig& rig, double contrast) {
  std::vector<double> cost;
  for (std::size_t c = 0; c < rig.cells.key.size(); c++) {
    if (rig.cells.first[c] >= rig.particles.owned) continue;
    const Vec3i cell = cellOfKey(rig.cells.key[c]);
    const bool spot = 3 * cell.x < rig.cloud.grid.cells.x && 3 * cell.z < rig.cloud.grid.cells.z;
    cost.push_back(rig.cells.count[c] * (spot ? contrast : 1.0) * 1e-6);
  }
  return cost;
}

/// Costs that change by `ratio` from one corner of the domain to the opposite one.
std::vector<double> slopingCosts(const HaloRig& rig, double ratio) {
  std::vector<double> cost;
  const Vec3i n = rig.cloud.grid.cells;
  for (std::size_t c = 0; c < rig.cells.key.size(); c++) {
    if (rig.cells.first[c] >= rig.particles.owned) continue;
    const Vec3i cell = cellOfKey(rig.cells.key[c]);
    cost.push_back(rig.cells.count[c] *
                   std::pow(ratio, (1.0 * cell.x / n.x + 1.0 * cell.y / n.y + 1.0 * cell.z / n.z) / 3));
  }
  return cost;
}

/// The table of the owned cells, without ghost cells.
CellTable ownedCells(const HaloRig& rig) {
  CellTable t;
  for (std::size_t c = 0; c < rig.cells.key.size(); c++)
    if (rig.cells.first[c] < rig.particles.owned) {
      t.key.push_back(rig.cells.key[c]);
      t.first.push_back(rig.cells.first[c]);
      t.count.push_back(rig.cells.count[c]);
    }
  t.ownedCells = t.key.size();
  return t;
}

double measuredImbalance(std::span<const double> cost, Reducer& all) {
  double sum = 0;
  for (const double c : cost) sum += c;
  double largest[1] = {sum};
  std::int64_t total[1] = {static_cast<std::int64_t>(sum * 1e12)};
  all.maximum(largest);
  all.sum(total);
  return largest[0] * all.size() / (static_cast<double>(total[0]) * 1e-12);
}

void run(const Cloud& cloud, bool spread, std::size_t chunk = largestChunk) {
  const CellGrid& g = cloud.grid;
  SCOPED_TRACE(testing::Message() << "cells " << g.cells.x << ' ' << g.cells.y << ' ' << g.cells.z
                                  << ", particles " << cloud.number << ", periodic " << g.periodic[0]
                                  << g.periodic[1] << g.periodic[2]);
  const Communicator comm(MPI_COMM_WORLD, chunk);
  MpiReducer all(comm);
  MpiCellHalo halo(comm, cloud.grid);
  checkTiling(cloud.grid, halo, all);
  HaloRig rig(cloud, halo, all);
  rig.start(spread);
  rig.checkAll();
  for (rig.cloud.time = 1; rig.cloud.time < 5; rig.cloud.time++) {
    // with and without the ghost cells
    const CellTable table = rig.cloud.time % 2 ? rig.cells : ownedCells(rig);
    if (halo.rebalance(table, costs(rig, rig.cloud.time % 2 ? 50 : 1), rig.cloud.time < 4))
      checkTiling(cloud.grid, halo, all);
    rig.place();
    rig.checkAll();
  }
}

}  // namespace

TEST(CellHalo, HandlesEveryChoiceOfPeriodicAxes) {
  for (int periodic = 0; periodic < 8; periodic++) {
    run({plainGrid({5, 4, 6}, periodic), 700}, true);
    run({plainGrid({3, 3, 3}, periodic), 300}, false);
  }
}

TEST(CellHalo, HandlesManyParticlesOnOneRankAtFirst) { run({plainGrid({12, 9, 10}, 5), 6000}, false); }

TEST(CellHalo, HandlesFewOrNoParticles) {
  for (int periodic : {0, 7})
    for (const std::uint64_t number : {0, 1, 2, 5})
      run({plainGrid({7, 5, 4}, periodic), number}, number % 2 == 0);
}

TEST(CellHalo, HandlesAllParticlesInOneCell) {
  for (int periodic : {0, 3, 7}) run({plainGrid({5, 4, 6}, periodic), 400, true}, true);
}

TEST(CellHalo, HandlesMoreRanksThanCells) {
  run({plainGrid({1, 1, 1}, 0), 50}, true);
  run({plainGrid({2, 1, 1}, 0), 50}, false);
  run({plainGrid({1, 3, 1}, 2), 50}, true);
}

TEST(CellHalo, SplitsMessagesIntoChunks) {
  for (const std::size_t chunk : {smallestChunk, std::size_t{96}, std::size_t{1000}})
    run({plainGrid({5, 4, 6}, 5), 700}, false, chunk);
  run({plainGrid({4, 3, 3}, 1), 3000}, true, 4096);
}

TEST(CellHalo, HandlesAHugeSparseGrid) {  // no array may have the size of the grid
  CellGrid g = plainGrid({maxCellsPerAxis, maxCellsPerAxis, maxCellsPerAxis}, 7);
  const Communicator comm;
  MpiReducer all(comm);
  MpiCellHalo halo(comm, g);
  HaloRig rig({g, 300}, halo, all);
  rig.start(true);
  rig.exchange();
  rig.checkOwned();
  EXPECT_TRUE(halo.rebalance(ownedCells(rig), costs(rig, 1), true) || comm.size() == 1);
  rig.exchange();
  rig.checkOwned();
  EXPECT_LT(measuredImbalance(costs(rig, 1), all), 1.15);
}

TEST(CellHalo, ReleasesBuffersOfTheFirstMigration) {
  const Communicator comm;
  MpiReducer all(comm);
  const Cloud cloud{plainGrid({12, 9, 10}, 0), 20000};
  MpiCellHalo halo(comm, cloud.grid);
  HaloRig rig(cloud, halo, all);
  rig.start(false);  // all particles start on one rank
  computeCellKeys(cloud.grid, rig.particles);
  halo.migrate(rig.particles, {rig.particles.nextCell.data(), rig.particles.owned});
  EXPECT_LT(halo.bufferBytes(), 10000u);
}

TEST(CellHalo, GrowsBuffersOfMessages) {
  Cloud cloud{plainGrid({4, 3, 3}, 1), 20000};
  const Communicator comm;
  MpiReducer all(comm);
  MpiCellHalo halo(comm, cloud.grid);
  HaloRig rig(cloud, halo, all);
  rig.start(true);
  for (int round = 0; round < 3; round++) {
    rig.exchange();
    rig.checkOwned();
    rig.checkRefresh();
    std::int64_t ghosts[1] = {static_cast<std::int64_t>(rig.particles.ghosts)};
    all.sum(ghosts);
    EXPECT_GT(ghosts[0], 0);
    rig.cloud.time++;
    rig.place();
  }
}

TEST(CellHalo, RebalanceEvensOutStronglyUnevenCosts) {
  Cloud cloud{plainGrid({40, 30, 36}, 0), 20000};
  const Communicator comm;
  MpiReducer all(comm);
  MpiCellHalo halo(comm, cloud.grid);
  HaloRig rig(cloud, halo, all);
  rig.start(true);
  rig.exchange();
  const double before = measuredImbalance(costs(rig, 40), all);
  EXPECT_EQ(halo.rebalance(ownedCells(rig), costs(rig, 40), false), comm.size() > 1);
  const double predicted = halo.imbalance();
  rig.exchange();
  rig.checkOwned();
  const double after = measuredImbalance(costs(rig, 40), all);
  if (comm.size() == 1) return;
  EXPECT_GT(before, 1.3);
  EXPECT_LT(after, 1.15);
  EXPECT_NEAR(after, predicted, 1e-6);
  // the costs are even, so nothing changes
  for (int call = 0; call < 15; call++) EXPECT_FALSE(halo.rebalance(rig.cells, costs(rig, 40), false));
  EXPECT_NEAR(halo.imbalance(), after, 1e-6);
}

TEST(CellHalo, RebalancePausesAfterAChange) {
  Cloud cloud{plainGrid({30, 30, 30}, 0), 5000};
  const Communicator comm;
  MpiReducer all(comm);
  BalanceRule rule;
  rule.pause = 3;
  MpiCellHalo halo(comm, cloud.grid, rule);
  if (comm.size() == 1) return;
  HaloRig rig(cloud, halo, all);
  rig.start(true);
  rig.exchange();
  ASSERT_TRUE(halo.rebalance(ownedCells(rig), slopingCosts(rig, 1000), false));
  rig.exchange();
  for (int call = 0; call < 3; call++)
    EXPECT_FALSE(halo.rebalance(ownedCells(rig), slopingCosts(rig, 0.001), false));
  EXPECT_TRUE(halo.rebalance(ownedCells(rig), slopingCosts(rig, 0.001), false));
  rig.exchange();
  rig.checkOwned();
}

TEST(CellHalo, ToleratesNonFiniteCosts) {
  Cloud cloud{plainGrid({8, 8, 8}, 0), 500};
  const Communicator comm;
  MpiReducer all(comm);
  MpiCellHalo halo(comm, cloud.grid);
  HaloRig rig(cloud, halo, all);
  rig.start(true);
  rig.exchange();
  std::vector<double> cost = costs(rig, 1);
  for (std::size_t c = 0; c < cost.size(); c += 3) cost[c] = c % 2 ? -1 : 0.0 / 0.0;
  halo.rebalance(ownedCells(rig), cost, true);
  rig.exchange();
  rig.checkOwned();
  std::vector<double> none(ownedCells(rig).key.size(), 0);
  EXPECT_FALSE(halo.rebalance(ownedCells(rig), none, true));
}

TEST(CellHalo, KeepsRowsWithoutACell) {
  const Communicator comm;
  MpiReducer all(comm);
  MpiCellHalo halo(comm, plainGrid({6, 6, 6}, 0));
  HaloRig rig({plainGrid({6, 6, 6}, 0), 300}, halo, all);
  rig.start(true);
  Continuum& p = rig.particles;
  computeCellKeys(rig.cloud.grid, p);
  std::vector<std::uint32_t> leaving;
  std::int64_t number[1] = {static_cast<std::int64_t>(p.owned)};
  for (std::size_t i = 0; i < p.owned; i += 4) {
    p.nextCell[i] = noCell;
    leaving.push_back(static_cast<std::uint32_t>(i));
  }
  number[0] -= static_cast<std::int64_t>(leaving.size());
  Migration m = halo.migrate(p, {p.nextCell.data(), p.owned});
  for (const std::uint32_t row : m.departed) EXPECT_NE(row % 4, 0u);
  // New rows of this step may leave at once: all rows except the departed ones count as arrivals here.
  computeCellKeys(rig.cloud.grid, p);
  std::vector<std::uint32_t> gone;
  std::merge(m.departed.begin(), m.departed.end(), leaving.begin(), leaving.end(), std::back_inserter(gone));
  m.departed = gone;
  m.arrivals = p.owned;
  sortByCell(p, m, rig.sort, rig.cells);
  all.sum(number);
  std::int64_t now[1] = {static_cast<std::int64_t>(p.owned)};
  all.sum(now);
  EXPECT_EQ(now[0], number[0]);
  for (std::size_t i = 0; i < p.owned; i++) EXPECT_TRUE(halo.owns(p.cell[i]));
}

TEST(CellHalo, RefusesAShortPeriodicAxis) {
  const Communicator comm;
  EXPECT_THROW(MpiCellHalo(comm, plainGrid({2, 8, 8}, 1)), std::invalid_argument);
}
