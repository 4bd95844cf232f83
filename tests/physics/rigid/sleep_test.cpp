// SPDX-License-Identifier: Apache-2.0
// Rigid pieces at rest sleep (core/rigid/sleeping_pieces.hpp), and wake by contact, moving and vanishing
// obstacles, and by melting.
#include <gtest/gtest.h>

#include "tests/support/rigid/scenes.hpp"

using namespace thaw;
using namespace thaw::test;

namespace {

constexpr double spacing = 0.1, edge = 0.4;

/// A stack of stone boxes on a floor, slightly offset from each other.
Scene stack(int boxes) {
  Scene s = emptyScene(spacing, {-1, -1, -0.5}, {3, 1, 6});
  s.domain.gravity = {0, 0, -9.81};
  addFloor(s);
  s.materials.push_back(stone());
  for (int k = 0; k < boxes; k++) {
    const double x = 0.01 * (k % 3), y = 0.01 * (k % 2), z = edge * k;
    addBox(s, {x - edge / 2, y - edge / 2, z}, {x + edge / 2, y + edge / 2, z + edge});
  }
  s.numerics.sleepSpeed = 0.05;
  s.numerics.sleepAfter = 0.05;
  s.numerics.maxStep = 2e-3;
  s.end = 10;
  return s;
}

std::size_t sleepers(const Pieces& p) {
  std::size_t n = 0;
  for (std::size_t k = 0; k < p.owned; k++) n += p.sleeping[k];
  return n;
}

bool runUntil(Simulation& sim, double time) {
  while (sim.w.clock.time < time)
    if (!sim.step()) return false;
  return true;
}

TEST(RigidSleep, AStackOfTenBoxesIsAsleepAfterTenSeconds) {
  Simulation sim(stack(10));
  const Pieces& p = sim.w.pieces;
  ASSERT_EQ(p.owned, 10u);
  std::vector<Vec3d> start(p.centre.data(), p.centre.data() + p.owned);
  ASSERT_TRUE(runUntil(sim, 9));
  EXPECT_EQ(sleepers(p), 10u);
  const std::int64_t iterations = sim.w.counters.contactIterations;
  ASSERT_TRUE(runUntil(sim, 10));
  EXPECT_EQ(sleepers(p), 10u);
  EXPECT_EQ(sim.w.counters.contactIterations, iterations) << "contacts among sleeping pieces are solved";
  EXPECT_EQ(sim.w.counters.sleeping, static_cast<std::int64_t>(sim.particles().owned));
  for (std::size_t k = 0; k < p.owned; k++) EXPECT_LT(length(p.centre[k] - start[k]), 0.1 * spacing);
  const LedgerReport now = sim.ledgerReport();
  EXPECT_LT(length(now.momentumResidual), 1e-6 * now.now.mass);
  EXPECT_LT(std::abs(now.energyResidual), 1e-3 * now.energyScale);
}

TEST(RigidSleep, AFallingBoxWakesTheStackThatItHits) {
  Scene s = stack(3);
  s.domain.min = {-4, -4, -0.5};  // room for the rebound of the box
  s.domain.max = {6, 4, 6};
  addBox(s, {-0.2, -0.2, 4}, {0.2, 0.2, 4.4});
  addBox(s, {2, -0.2, 0}, {2.4, 0.2, 0.4});  // far away
  Simulation sim(s);
  const Pieces& p = sim.w.pieces;
  const double hit = std::sqrt(2 * (4 - 3 * edge) / 9.81);
  ASSERT_TRUE(runUntil(sim, hit - 0.02));
  EXPECT_EQ(sleepers(p), 4u);
  ASSERT_TRUE(runUntil(sim, hit + 0.02));
  EXPECT_EQ(sleepers(p), 1u) << "only the box far away sleeps";
  EXPECT_TRUE(p.sleeping[4]);
  EXPECT_LT(length(sim.ledgerReport().momentumResidual), 1e-6 * sim.ledgerReport().now.mass);
  ASSERT_TRUE(runUntil(sim, 5));
  EXPECT_EQ(sleepers(p), 5u);
}

TEST(RigidSleep, NoPieceSleepsInTheAir) {
  Scene s = stack(1);
  s.obstacles.clear();
  s.bodies[0].velocity = {0, 0, 1};
  s.numerics.sleepSpeed = 1;
  s.end = 0.2;
  Simulation sim(s);
  while (sim.w.clock.time < s.end) {
    ASSERT_TRUE(sim.step());
    ASSERT_EQ(sleepers(sim.w.pieces), 0u);
  }
  EXPECT_NEAR(sim.w.pieces.momentum[0].z / sim.w.pieces.mass[0], 1 - 9.81 * sim.w.clock.time, 1e-9);
}

TEST(RigidSleep, APushingObstacleWakesThePushedPiece) {
  Scene s = stack(1);
  addBox(s, {2, -0.2, 0}, {2.4, 0.2, 0.4});
  s.obstacles.emplace_back();
  Obstacle& ram = s.obstacles.back();
  ram.name = "ram";
  ram.shape.size = {0.4, 1, 0.3};
  ram.shape.move = {-0.5, 0, 0.2};
  ram.motion = {{0.5, {0, 0, 0}, {}}, {1, {0.3, 0, 0}, {}}};
  Simulation sim(s);
  const Pieces& p = sim.w.pieces;
  ASSERT_TRUE(runUntil(sim, 0.45));
  EXPECT_EQ(sleepers(p), 2u);
  ASSERT_TRUE(runUntil(sim, 0.95));
  EXPECT_FALSE(p.sleeping[0]);
  EXPECT_TRUE(p.sleeping[1]);
  EXPECT_GT(p.centre[0].x, 0.1);
}

TEST(RigidSleep, PiecesOnAVanishingObstacleFall) {
  Scene s = stack(2);
  s.obstacles.back().until = 0.5;
  Simulation sim(s);
  ASSERT_TRUE(runUntil(sim, 0.48));
  EXPECT_EQ(sleepers(sim.w.pieces), 2u);
  ASSERT_TRUE(runUntil(sim, 0.6));
  EXPECT_EQ(sleepers(sim.w.pieces), 0u);
  EXPECT_LT(sim.w.pieces.momentum[0].z, -0.5 * 9.81 * 0.1 * sim.w.pieces.mass[0]);
}

TEST(RigidSleep, PiecesOnAMeltingPieceWake) {
  Scene s = stack(3);
  s.materials.push_back(rigidWax());
  for (auto& side : s.domain.side) side = {Side::Wall, Side::Wall};
  s.bodies[0].material = 1;
  for (Body& b : s.bodies) b.temperature = 300;
  s.thermostats.emplace_back();
  s.thermostats[0].start = 100;
  s.materials[1].soundSpeed = 40;
  s.materials[1].viscosity = {50, 50};
  Simulation sim(s);
  ASSERT_TRUE(runUntil(sim, 0.3));
  EXPECT_EQ(sleepers(sim.w.pieces), 3u);
  Continuum& p = sim.particles();
  for (std::size_t i = 0; i < p.owned; i++)
    if (p.body[i] == 0) p.enthalpy[i] = 1e5;
  for (int k = 0; k < 5; k++) ASSERT_TRUE(sim.step());
  EXPECT_GT(sim.w.counters.melted, 0);
  EXPECT_EQ(sleepers(sim.w.pieces), 0u);
}

}  // namespace
