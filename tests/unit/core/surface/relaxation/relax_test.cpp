// SPDX-License-Identifier: Apache-2.0
#include "core/surface/relaxation/relax.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <map>
#include <numbers>

#include "core/surface/data/level_table.hpp"
#include "core/surface/field/prepare_particles.hpp"
#include "core/surface/relaxation/blend.hpp"
#include "tests/support/surface/relax_rig.hpp"

namespace thaw {
namespace {

using test::addBall;
using test::places;
using test::RelaxRig;

bool sameBits(const std::map<std::uint64_t, Vec3d>& a, const std::map<std::uint64_t, Vec3d>& b) {
  return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(), [](const auto& x, const auto& y) {
           return x.first == y.first && std::memcmp(&x.second, &y.second, sizeof(Vec3d)) == 0;
         });
}

void addFloorAt(RelaxRig& rig, double z) {
  Domain domain = rig.w.scene.domain;
  domain.min.z = z;
  domain.side[2][0] = Side::Wall;
  addDomainWalls(domain, rig.w.walls);
}

TEST(Relax, BallOfLatticeParticlesIsAccurate) {  // limits at R/dx = 16; the lattice has 0.57 % more volume
                                                 // than the
                                                 // ball
  RelaxRig rig;
  addBall(rig, 16);
  const double particles = static_cast<double>(rig.w.surface.particles.owned);
  rig.relaxSurfels(60);
  const double same = std::cbrt(particles / (4.0 / 3 * std::numbers::pi));
  const test::BallErrors e = test::ballErrors(rig.w.surface.surfels, same);
  EXPECT_LT(e.hausdorff, 0.01);
  EXPECT_LT(std::abs(e.mean), 5e-4);
  EXPECT_LT(std::abs(e.volume), 2e-3);
  EXPECT_LT(e.normalMean, 1.5);
  EXPECT_LT(e.normalMax, 6);
}

TEST(Relax, DropsOfFewParticlesKeepTheirVolume) {
  const std::vector<Vec3d> all{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0},
                               {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}};
  for (std::size_t n : {1u, 2u, 4u, 8u}) {
    RelaxRig rig(0.25);
    Vec3d middle{};
    for (std::size_t k = 0; k < n; k++) rig.addParticle(all[k]), middle += all[k] / static_cast<double>(n);
    const double R = std::cbrt(static_cast<double>(n) * 3 / (4 * std::numbers::pi));
    rig.addBallSurfels(1.3 * R);
    for (std::size_t i = 0; i < rig.w.surface.surfels.owned; i++) rig.w.surface.surfels.position[i] += middle;
    rig.place();
    rig.relaxSurfels(60);
    const Surfels& s = rig.w.surface.surfels;
    double mean = 0;
    for (std::size_t i = 0; i < s.owned; i++)
      mean += length(s.position[i] - middle) / static_cast<double>(s.owned);
    EXPECT_NEAR(mean / R, 1, n == 1 ? 0.01 : 0.08) << n;
  }
}

TEST(Relax, PlanesAndSpheresAreAtRestUnderSmoothing) {
  RelaxRig rig(0.5, 12, [](Scene& s) {
    s.surface.implicit = s.surface.attract = s.surface.repel = 0, s.surface.smooth = 0.5;
  });
  rig.addBallSurfels(5);
  rig.place();
  const auto before = places(rig.w.surface.surfels);
  rig.relaxSurfels(20);
  for (const auto& [id, x] : places(rig.w.surface.surfels)) EXPECT_LT(length(x - before.at(id)), 2e-6);

  for (SmoothingForm form : {SmoothingForm::Sphere, SmoothingForm::Plane}) {
    RelaxRig flat(0.5, 12, [&](Scene& s) {
      s.surface.implicit = s.surface.attract = s.surface.repel = 0, s.surface.smooth = 0.5,
      s.surface.smoothing = form;
    });
    for (int y = -8; y <= 8; y++)
      for (int x = -8; x <= 8; x++)
        flat.addSurfel({0.5 * x, 0.5 * y, 0.1 * x + (x == 1 && y == 2 ? 0.1 : 0)}, {-0.2, 0, 1});
    flat.place();
    flat.relaxSurfels(200);
    const Surfels& s = flat.w.surface.surfels;
    for (std::size_t i = 0; i < s.owned; i++)
      EXPECT_NEAR(s.position[i].z, 0.2 * s.position[i].x, 0.02) << "the bump vanishes";
  }
}

TEST(Relax, RepulsionSpacesEvenly) {
  RelaxRig rig(0.5, 12, [](Scene& s) {
    s.surface.implicit = 1, s.surface.attract = s.surface.smooth = 0, s.surface.repel = 0.3;
  });
  addBall(rig, 6, 0.2);
  const auto closest = [&] {
    const Surfels& s = rig.w.surface.surfels;
    double least = 1e9;
    for (std::size_t i = 0; i < s.owned; i++)
      for (std::size_t j = 0; j < i; j++) least = std::min(least, length(s.position[i] - s.position[j]));
    return least;
  };
  const double before = closest();
  for (int k = 0; k < 4; k++) rig.relaxSurfels(15);
  EXPECT_LT(before, 0.25);
  EXPECT_GT(closest(), 0.35);
}

TEST(Relax, SameBitsForEveryInstructionSetAndGrouping) {
  for (SmoothingForm form : {SmoothingForm::Sphere, SmoothingForm::Plane}) {
    std::map<std::uint64_t, Vec3d> first;
    for (const char* isa : {"base", "avx2", "avx512"}) {
      if (!surfaceKernels(isa)) continue;
      RelaxRig rig(0.5, 12, [&](Scene& s) { s.surface.smoothing = form; });
      rig.tools.relax.kernels = surfaceKernels(isa);
      addBall(rig, 5);
      rig.relaxSurfels(12);
      const auto now = places(rig.w.surface.surfels);
      if (first.empty()) first = now;
      EXPECT_TRUE(sameBits(first, now)) << isa;
    }
    // a rank with half of the ball's surfels groups them differently: one iteration from the same positions,
    // with all neighbours present
    RelaxRig rig(0.5, 12, [&](Scene& s) { s.surface.smoothing = form; });
    RelaxRig half(0.5, 12, [&](Scene& s) { s.surface.smoothing = form; });
    addBall(rig, 5);
    addBall(half, 5);
    for (std::size_t i = 0; i < half.w.surface.surfels.owned; i++)
      half.w.surface.surfels.liquid[i] = half.w.surface.surfels.id[i] % 3 == 0 ? 1.0f : 0.0f;
    rig.relaxSurfels(1);
    half.relaxSurfels(1, false);
    const auto all = places(rig.w.surface.surfels), some = places(half.w.surface.surfels);
    for (const auto& [id, x] : some)
      if (id % 3 == 0) { EXPECT_EQ(std::memcmp(&x, &all.at(id), sizeof(Vec3d)), 0); }
  }
}

TEST(Relax, LocalStopGivesWhatAllSurfelsGive) {
  RelaxRig local, whole(0.5, 24, [](Scene&s) { s.surface.stop = 1e-9; });
  addBall(local, 8);
  addBall(whole, 8);
  const RelaxationResult a = local.relaxSurfels(200);
  whole.relaxSurfels(200);
  EXPECT_TRUE(a.finished);
  EXPECT_LT(local.tools.relax.times.surfels, whole.tools.relax.times.surfels / 4);
  const auto x = places(local.w.surface.surfels), y = places(whole.w.surface.surfels);
  double sum = 0, height = 0;
  for (const auto& [id, at] : x) {
    sum += length(at - y.at(id)) / static_cast<double>(x.size());
    height = std::max(height, std::abs(length(at) - length(y.at(id))));
  }
  EXPECT_LT(sum, 10 * 0.01 * 0.5);  // tangential motion continues
  EXPECT_LT(height, 2 * 0.01 * 0.5 + 0.02);
}

TEST(Relax, SolidsAreUnchanged) {
  RelaxRig rig;
  addBall(rig, 5);
  Surfels& s = rig.w.surface.surfels;
  for (std::size_t i = 0; i < s.owned; i++) s.liquid[i] = s.position[i].z > 0 ? 0.0f : 1.0f;
  const auto before = places(s);
  rig.relaxSurfels(20, false);
  for (std::size_t i = 0; i < s.owned; i++)
    if (s.liquid[i] == 0) { EXPECT_EQ(s.position[i], before.at(s.id[i])); }
  for (std::size_t i = 0; i < s.owned; i++) s.liquid[i] = 0;
  rig.tools.relax.times = {};
  EXPECT_TRUE(rig.relaxSurfels(20, false).finished);
  EXPECT_EQ(rig.tools.relax.times.surfels, 0);
}

TEST(Relax, RespectsObstaclesAndTheLowestLevel) {
  RelaxRig rig;
  addFloorAt(rig, -4);
  addBall(rig, 5);
  rig.relaxSurfels(40);
  const Surfels& s = rig.w.surface.surfels;
  for (std::size_t i = 0; i < s.owned; i++) EXPECT_GE(s.position[i].z, -4 - 1e-9);

  RelaxRig far(0.5, 24, [](Scene& s) {
    s.surface.implicit = 0, s.surface.smooth = 0, s.surface.attract = 0, s.surface.repel = 0;
  });
  far.addLattice(6, {0.5, 0.5, 0.5}, [&](const Vec3d& x) { return length(x) < 5; });
  far.addSurfel({0, 0, 7.5}, {0, 0, 1});
  far.place();
  far.relaxSurfels(40);
  const double z = far.w.surface.surfels.position[0].z;
  EXPECT_LT(z, 7);
  EXPECT_GT(z, 5);
}

// A wall that holds a surfel back must not make it creep along, although its normal deviates from the wall's
// by a few degrees.
TEST(Relax, LiquidOnAWallComesToRest) {
  RelaxRig rig;
  addFloorAt(rig, -4);
  addBall(rig, 5);
  rig.relaxSurfels(40);
  std::int64_t most = 0;
  for (int k = 0; k < 3; k++) {
    const RelaxationResult done = rig.relaxSurfels(40);
    EXPECT_TRUE(done.finished);
    most = std::max(most, done.iterations);
  }
  EXPECT_LE(most, 20);
}

}  // namespace
}  // namespace thaw
