// SPDX-License-Identifier: Apache-2.0
// Components of bodies across ranks have the labels, events and measures of a single process, bit by bit
// (docs/validation/stability.md, row 30).
#include <map>

#include "core/math/hash_random.hpp"
#include "parallel/row_scatter.hpp"
#include "tests/support/surface/surface_rig.hpp"

using namespace thaw;
using namespace thaw::test;

namespace {

/// A long wire, two touching balls, a ball across a periodic side, a dumbbell, a drop in a pool, and a spray.
template<class Rig> void fill(Rig& rig) {
  rig.box({-1.9, -0.1, 1.5}, {38, 2, 2});  // crosses all ranks
  rig.body = 1;
  rig.ball({-0.5, -1.2, -0.6}, 0.4);
  rig.body = 2;
  rig.ball({0.15, -1.2, -0.6}, 0.4);
  rig.body = 3;
  rig.ball({1.95, 1.2, -0.5}, 0.5);  // periodic
  rig.body = 4;
  rig.ball({-0.6, 1.2, 0.7}, 0.4, 1000000);
  rig.ball({0.6, 1.2, 0.7}, 0.4, 1000000);  // a single component at first
  rig.sphere({0, 1.5, 0}, 0.05, 1000000);   // surfels without particles
  rig.body = 5;
  rig.box({-1.5, -1.5, -1.9}, {30, 20, 5});
  rig.body = 6;
  rig.ball({0, -0.7, -1.3}, 0.25);
  for (int k = 0; k < 40; k++) {
    rig.body = static_cast<std::uint16_t>(10 + k);
    const auto u = [&](std::uint64_t s) {
      return randomUniform(s, Purpose::Test, static_cast<std::uint64_t>(k));
    };
    rig.ball({-1.7 + 3.4 * u(1), -0.4 + 0.8 * u(2), 0.2 + u(3)}, 0.12);
  }
  for (int k = 0; k < 10; k++)
    rig.particle({-0.6 + 0.02 * k, 1.2 + 0.01 * k, 1.1 + 0.07 * k});  // new particles
}

struct World3 {
  SurfaceRig rig;
  World3() {
    rig.world.scene.domain.side[0] = {Side::Periodic, Side::Periodic};
    rig.world.scene.surface.enforceVolume = 0.5;
    prepareSurface(rig.world);
  }
};

void expectSame(const SurfaceComponent& a, const SurfaceComponent& b) {
  EXPECT_EQ(a.label, b.label);
  EXPECT_EQ(a.particles, b.particles);
  EXPECT_EQ(a.surfels, b.surfels);
  EXPECT_EQ(a.mass, b.mass);
  EXPECT_EQ(a.particleVolume, b.particleVolume);
  EXPECT_EQ(a.volume, b.volume);
  EXPECT_EQ(a.area, b.area);
  EXPECT_EQ(a.centroid, b.centroid);
}

}  // namespace

TEST(SurfaceComponents, EqualThoseOfASingleProcess) {
  const Communicator comm;
  World3 whole, part;
  SerialSurfaceRanks serial(whole.rig.world.surface.grid);
  part.rig.rank = comm.rank();
  part.rig.ranks = comm.size();
  SurfaceRanks halos(comm, part.rig.world.surface.grid);
  fill(whole.rig);
  fill(part.rig);

  for (int update = 0; update < 3; update++) {
    whole.rig.update(serial.halos());
    part.rig.update(halos.halos());
    const Surface &a = whole.rig.world.surface, &b = part.rig.world.surface;
    ASSERT_EQ(a.components.size(), b.components.size());
    for (std::size_t k = 0; k < a.components.size(); k++) expectSame(a.components[k], b.components[k]);
    ASSERT_EQ(a.events.size(), b.events.size());
    for (std::size_t k = 0; k < a.events.size(); k++) {
      EXPECT_EQ(a.events[k].kind, b.events[k].kind);
      EXPECT_EQ(a.events[k].label, b.events[k].label);
      EXPECT_EQ(a.events[k].other, b.events[k].other);
    }
    EXPECT_EQ(a.counters.lost, b.counters.lost);
    EXPECT_EQ(a.counters.deaths, b.counters.deaths);

    std::map<std::uint64_t, std::size_t> row;
    for (std::size_t i = 0; i < a.surfels.owned; i++) row[a.surfels.id[i]] = i;
    std::int64_t surfels[1] = {static_cast<std::int64_t>(b.surfels.owned)};
    for (std::size_t i = 0; i < b.surfels.owned; i++) {
      ASSERT_EQ(row.count(b.surfels.id[i]), 1u);
      const std::size_t j = row[b.surfels.id[i]];
      EXPECT_EQ(b.surfels.component[i], a.surfels.component[j]);
      EXPECT_EQ(b.surfels.area[i], a.surfels.area[j]);
      EXPECT_EQ(b.surfels.position[i], a.surfels.position[j]);
    }
    halos.all.sum(surfels);
    EXPECT_EQ(surfels[0], static_cast<std::int64_t>(a.surfels.owned));
    const std::vector<std::uint64_t> labels = whole.rig.labels();
    for (std::size_t i = 0; i < b.particles.owned; i++)
      EXPECT_EQ(b.particles.component[i], labels[b.particles.id[i]]);
    if (update == 0) {
      EXPECT_EQ(a.counters.splits, 1);
      EXPECT_GE(a.counters.merges, 2);
      EXPECT_GT(a.counters.lost, 0);
    }
    // the wire breaks, a ball moves into another
    for (SurfaceRig* rig : {&whole.rig, &part.rig}) {
      for (std::size_t i = 0; i < rig->p().owned; i++)
        if (rig->p().position[i].z > 1.4 && rig->p().position[i].x > 0.31) rig->p().position[i].y += 0.3;
      for (std::size_t i = 0; i < rig->f().owned; i++)
        if (rig->f().position[i].z > 1.4 && rig->f().position[i].x > 0.31) rig->f().position[i].y += 0.3;
    }
  }
  EXPECT_GE(whole.rig.world.surface.counters.splits, 2);
}
