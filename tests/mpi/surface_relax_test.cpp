// SPDX-License-Identifier: Apache-2.0
// An update of the surface (displacement, iterations, blend) gives the same bits on any number of ranks.
#include <gtest/gtest.h>
#include <mpi.h>

#include <cstring>
#include <map>

#include "core/simulation/views/views.hpp"
#include "core/surface/advection/displace.hpp"
#include "core/surface/field/prepare_particles.hpp"
#include "core/surface/relaxation/blend.hpp"
#include "parallel/row_scatter.hpp"
#include "tests/support/surface/relax_rig.hpp"

using namespace thaw;
using test::RelaxRig;

namespace {

/// A ball across the periodic side along x, half molten, with some surfels beyond the reach of the particles.
std::unique_ptr<RelaxRig> ball(bool periodic) {
  auto made = std::make_unique<RelaxRig>(0.5, 14, [&](Scene& s) {
    if (periodic) s.domain.side[0] = {Side::Periodic, Side::Periodic};
  });
  RelaxRig& rig = *made;
  const Vec3d middle{periodic ? 13.0 : 2.0, 1, -1};
  rig.addLattice(7, {0.5, 0.5, 0.5}, [](const Vec3d& x) { return length(x) < 6; });
  rig.addBallSurfels(6, 0.15);
  rig.addSurfel({0, 0, 9.5}, {0, 0, 1});
  rig.addSurfel({0.2, 0, 10.2}, {0, 0, 1});
  SurfaceParticles& p = rig.w.surface.particles;
  for (std::size_t i = 0; i < p.owned; i++) {
    const Vec3d x = p.position[i];
    p.displacement[i] = Vec3d{0.03 * x.y, 0.05 * std::sin(x.x), 0.04 * x.z};
    p.liquid[i] = static_cast<float>(std::clamp(0.4 - 0.3 * x.z, 0.0, 1.0));
    p.position[i] = x + middle;
  }
  Surfels& s = rig.w.surface.surfels;
  s.activate(s.maxLiquidFraction);
  s.activate(s.detailHeight);
  for (std::size_t i = 0; i < s.owned; i++) s.position[i] += middle;
  return made;
}

void update(World& w, SurfaceHalos halos, SurfaceTools& t) {
  Surface& s = w.surface;
  const auto place = [&] {
    placeRows(s.grid, halos.surfels, s.surfels, s.surfelCells, t.sort);
    placeRows(s.grid, halos.particles, s.particles, s.particleCells, t.sort);
    t.relax.particlesPrepared = false;
  };
  for (int k = 0; k < 2; k++) {
    s.particles.resize(s.particles.owned, 0);
    place();
    findDisplacementGradients(w.grid, w.surface, halos, t);
    displaceSurfels(w.scene, w.surface, halos, t);
    s.particles.resize(s.particles.owned, 0);
    for (std::size_t i = 0; i < s.particles.owned; i++)
      s.particles.position[i] += s.particles.displacement[i];
    place();
    sampleFields(w.scene, w.surface, halos, t);
    relaxSurfels(surfaceView(w), halos, t, forceWeights(w.scene.surface), 15, false);
    blendSurfels(w.surface.surfels);
  }
}

struct Row {
  Vec3d position, normal, tangent;
  float liquid, detail, maxLiquidFraction, detailHeight;
};
Row rowOf(const Surfels& s, std::size_t i) {
  return {s.position[i],          s.normal[i],      s.tangent[i], s.liquid[i], s.detail[i],
          s.maxLiquidFraction[i], s.detailHeight[i]};
}

void keepShare(Table& rows, int rank, int size) {
  std::vector<std::uint32_t> kept;
  for (std::uint32_t i = 0; i < rows.owned; i++)
    if (static_cast<int>(i / 7) % size == rank) kept.push_back(i);
  rows.reorder(kept);
}

void compare(bool periodic) {
  const Communicator comm(MPI_COMM_WORLD);
  const auto one = ball(periodic), many = ball(periodic);
  RelaxRig &serial = *one, &mine = *many;
  update(serial.w, serial.ranks->halos(), serial.tools);
  SurfaceRanks ranks(comm, mine.w.surface.grid);
  keepShare(mine.w.surface.surfels, ranks.all.rank(), ranks.all.size());
  keepShare(mine.w.surface.particles, ranks.all.rank(), ranks.all.size());
  update(mine.w, ranks.halos(), mine.tools);
  std::map<std::uint64_t, Row> wanted;
  const Surfels &a = serial.w.surface.surfels, &b = mine.w.surface.surfels;
  for (std::size_t i = 0; i < a.owned; i++) wanted[a.id[i]] = rowOf(a, i);
  for (std::size_t i = 0; i < b.owned; i++) {
    ASSERT_TRUE(wanted.count(b.id[i]));
    const Row x = rowOf(b, i), &y = wanted[b.id[i]];
    EXPECT_EQ(std::memcmp(&x, &y, sizeof x), 0) << b.id[i] << " on rank " << ranks.all.rank();
  }
  std::int64_t rows[1]{static_cast<std::int64_t>(b.owned)};
  ranks.all.sum(rows);
  EXPECT_EQ(rows[0], static_cast<std::int64_t>(a.owned));
  EXPECT_EQ(mine.w.surface.counters.lost, serial.w.surface.counters.lost);
  EXPECT_EQ(mine.w.surface.counters.flipped, serial.w.surface.counters.flipped);
}

}  // namespace

TEST(SurfaceRelax, SameBitsAsOneProcess) { compare(false); }
TEST(SurfaceRelax, SameBitsAcrossPeriodicSides) { compare(true); }
