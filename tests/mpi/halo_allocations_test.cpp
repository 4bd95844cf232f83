// SPDX-License-Identifier: Apache-2.0
// A steady step allocates nothing in the halo. The test counts calls of operator new.
#include <gtest/gtest.h>

#include "parallel/cell_halo.hpp"
#include "tests/support/count_allocations.hpp"
#include "tests/support/halo_check.hpp"

using namespace thaw;
using namespace thaw::test;

TEST(CellHalo, SteadyStepAllocatesNothing) {
  const Communicator comm;
  MpiReducer all(comm);
  const Cloud cloud{plainGrid({6, 7, 8}, 5), 8000};
  MpiCellHalo halo(comm, cloud.grid);
  HaloRig rig(cloud, halo, all);
  rig.start(true);
  Continuum& p = rig.particles;
  AnyColumn* const columns[] = {&p.id, &p.position, &p.velocity, &p.liquid};
  AnyColumn* const refreshed[] = {&p.relativeDensity};
  for (int step = 0; step < 4; step++) {
    if (step < 2) rig.exchange();
    const long before = allocations;
    computeCellKeys(cloud.grid, p);
    const Migration m = halo.migrate(p, {p.nextCell.data(), p.owned});
    sortByCell(p, m, rig.sort, rig.cells);
    halo.beginGhosts(p, rig.cells, columns);
    halo.finishGhosts(p, rig.cells);
    halo.beginRefresh(p, refreshed);
    halo.finishRefresh(p);
    const long made = allocations - before;
    EXPECT_TRUE(step < 2 || made == 0) << made << " allocations";
  }
  EXPECT_GT(allocations, 0);
}
