// SPDX-License-Identifier: Apache-2.0
// Rigid pieces that melt, fall apart, freeze and touch: the same bits on any number of ranks.
#include <gtest/gtest.h>

#include "tests/support/rebalanced_run.hpp"
#include "tests/support/rigid/scenes.hpp"

using namespace thaw;
using namespace thaw::test;

namespace {

/// Sum of the hashes of all particles and of all pieces, over ranks.
struct StateHash {
  std::int64_t particles = 0, pieces = 0, pieceCount = 0, melted = 0, frozen = 0;
};

StateHash hashOf(const World& w, Reducer& all) {
  StateHash sum;
  const Continuum& p = w.particles;
  for (std::size_t i = 0; i < p.owned; i++) {
    std::uint64_t h = mixBits(p.id[i] + 1) + p.piece[i];
    for (int a = 0; a < 3; a++) h = mixed(mixed(h, p.position[i][a]), p.velocity[i][a]);
    sum.particles += static_cast<std::int64_t>(h >> 24);
  }
  for (std::size_t k = 0; k < w.pieces.owned; k++) {
    if (!w.pieces.recordsEnergy[k]) continue;
    std::uint64_t h = mixBits(w.pieces.id[k] + w.pieces.count[k]);
    for (int a = 0; a < 3; a++) {
      h = mixed(mixed(h, w.pieces.centre[k][a]), w.pieces.angularMomentum[k][a]);
      h = mixed(mixed(h, w.pieces.force[k][a]), w.pieces.contactImpulse[k][a]);
    }
    sum.pieces += static_cast<std::int64_t>(h >> 24);
    sum.pieceCount++;
  }
  sum.melted = w.counters.melted;
  sum.frozen = w.counters.frozen;
  all.sum({&sum.particles, sizeof sum / sizeof(std::int64_t)});
  return sum;
}

StateHash runOn(MPI_Comm group, const Scene& scene, int steps) {
  return runRebalanced(
      group, scene, steps, [](const World&) {}, hashOf);
}

TEST(Rigid, PiecesHaveTheSameBitsOnAnyNumberOfRanks) {
  const Scene scene = waxPieces();
  const StateHash alone = runOn(MPI_COMM_SELF, scene, 60), together = runOn(MPI_COMM_WORLD, scene, 60);
  EXPECT_GT(alone.melted, 0);
  EXPECT_GT(alone.frozen, 0);
  EXPECT_EQ(alone.pieceCount, together.pieceCount);
  EXPECT_EQ(alone.pieces, together.pieces);
  EXPECT_EQ(alone.particles, together.particles);
}

/// A bar of glass falls on a ridge beside a block at rest, and breaks. Its parts hit the floor and the block.
Scene barOnRidge() {
  Scene s = emptyScene(0.1, {-1.5, -0.5, -0.5}, {1.5, 0.5, 1});
  s.domain.gravity = {0, 0, -9.81};
  for (auto& side : s.domain.side) side = {Side::Wall, Side::Wall};
  Material glass = stone();
  glass.strength = 40e6;
  glass.impactModulus = 70e9;
  glass.restitution = 0.2;
  s.materials.push_back(glass);
  Body& bar = addBox(s, {-0.9, 0, 0.15}, {1.1, 0.2, 0.35});
  bar.velocity = {0, 0, -6};
  bar.spin = {0, 0.2, 0};
  addBox(s, {-1, -0.2, -0.5}, {-0.6, 0.2, -0.1});
  s.obstacles.emplace_back();
  s.obstacles.back().name = "ridge";
  s.obstacles.back().shape = boxOf({-0.1, -0.5, -0.5}, {0.1, 0.5, 0.05});
  s.numerics.maxStep = 2e-3;
  s.numerics.sleepSpeed = 0.05;
  s.numerics.sleepAfter = 0.004;
  return s;
}

TEST(Rigid, BreakingAndSleepHaveTheSameBitsOnAnyNumberOfRanks) {
  const auto run = [](MPI_Comm group) {
    bool slept = false;
    const auto look = [&](const World& w) { slept = slept || w.counters.sleeping > 0; };
    const StateHash hash = runRebalanced(group, barOnRidge(), 45, look, [&](const World& w, Reducer& all) {
      StateHash sum = hashOf(w, all);
      double any = slept ? 1 : 0;
      all.maximum({&any, 1});
      slept = any > 0;
      return sum;
    });
    EXPECT_TRUE(slept);
    return hash;
  };
  const StateHash alone = run(MPI_COMM_SELF), together = run(MPI_COMM_WORLD);
  EXPECT_GT(alone.pieceCount, 3);
  EXPECT_EQ(alone.pieceCount, together.pieceCount);
  EXPECT_EQ(alone.pieces, together.pieces);
  EXPECT_EQ(alone.particles, together.particles);
}

/// A row of hot bricks, longer than half of a periodic domain, on a plate that vanishes. Two of them slide
/// into the others. The last brick is cold.
Scene rowOfBricks() {
  constexpr int bricks = 8, sliding = 5;  // from this one on
  Scene s = emptyScene(0.1, {-2, -0.5, -0.5}, {2, 0.5, 1});
  s.domain.gravity = {0, 0, -9.81};
  s.domain.side[0] = {Side::Periodic, Side::Periodic};
  Material iron = stone(7800);
  iron.weldTemperature = 1000;
  iron.weldTime = 0.01;
  iron.restitution = 0;
  iron.heatCapacity = {450, 450};
  iron.conductivity = {50, 50};
  s.materials.push_back(iron);
  for (int k = 0; k < bricks; k++) {
    const bool slides = k == sliding || k == sliding + 1, last = k == bricks - 1;
    const double aside = slides ? 0.02 : 0.1 * last, place = 0.3 + 0.4 * k + aside,
                 x = place > 1.9 ? place - 4 : place;
    Body& b = addBox(s, {x, -0.1, 0}, {x + 0.4, 0.1, 0.2});
    b.temperature = last ? 900 : 1100;
    b.velocity.x = slides ? -0.5 : 0;
  }
  s.obstacles.emplace_back();
  s.obstacles.back().name = "plate";
  s.obstacles.back().shape = boxOf({-2, -0.5, -0.3}, {2, 0.5, 0});
  s.obstacles.back().until = 0.08;
  s.numerics.maxStep = 2e-3;
  return s;
}

TEST(Rigid, WeldsHaveTheSameBitsOnAnyNumberOfRanks) {
  const auto run = [](MPI_Comm group, std::int64_t& welded) {
    return runRebalanced(
        group, rowOfBricks(), 60, [](const World&) {},
        [&](const World& w, Reducer& all) {
          welded = w.counters.weldedPieces;
          all.sum({&welded, 1});
          return hashOf(w, all);
        });
  };
  std::int64_t weldedAlone = 0, weldedTogether = 0;
  const StateHash alone = run(MPI_COMM_SELF, weldedAlone), together = run(MPI_COMM_WORLD, weldedTogether);
  EXPECT_EQ(weldedAlone, 6);
  EXPECT_EQ(weldedTogether, 6);
  EXPECT_EQ(alone.pieceCount, 2);
  EXPECT_EQ(together.pieceCount, 2);
  EXPECT_EQ(alone.pieces, together.pieces);
  EXPECT_EQ(alone.particles, together.particles);
}

}  // namespace
