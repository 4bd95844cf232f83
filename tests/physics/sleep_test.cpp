// SPDX-License-Identifier: Apache-2.0
// Solids at rest sleep (core/sleep/): the same motion within tolerance, nearly no work, and waking by
// contact, a pushing wall and heat. No body sleeps in the air.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/simulation.hpp"

namespace thaw {
namespace {

/// A block on a floor, another block `gap` above that falls on it, and a third far away.
Scene blocks(double gap) {
  Scene s = test::emptyScene(0.1, {-2, -2, -0.5}, {6, 2, 6});
  s.domain.gravity = {0, 0, -9.81};
  test::addFloor(s);
  s.materials.emplace_back();
  s.materials[0].name = "rubber";
  s.materials[0].young = {1e6, 1e6};
  s.materials[0].density = 1000;
  s.materials[0].damping = 1000;
  s.materials[0].restitution = 0.2;
  test::addBox(s, {-0.5, -0.5, 0.05}, {0.5, 0.5, 0.55});
  test::addBox(s, {-0.3, -0.3, 0.65 + gap}, {0.3, 0.3, 0.95 + gap});
  test::addBox(s, {3.5, -0.5, 0.05}, {4.5, 0.5, 0.55});
  s.end = 2;
  return s;
}

double lowest(const Continuum& p, std::uint16_t body) {
  double z = never;
  for (std::size_t i = 0; i < p.owned; i++)
    if (p.body[i] == body) z = std::min(z, p.position[i].z);
  return z;
}

TEST(Sleep, BlocksAtRestSleepAndKeepTheirPosition) {
  Scene s = blocks(0.1);
  test::Simulation awakeOnes(s);
  ASSERT_TRUE(awakeOnes.run());
  s.numerics.sleepSpeed = 0.02;
  s.numerics.sleepAfter = 0.02;
  test::Simulation x(s);
  ASSERT_TRUE(x.run());
  EXPECT_EQ(x.w.counters.sleeping, static_cast<std::int64_t>(x.particles().owned));
  for (std::size_t i = 0; i < x.particles().owned; i++) {
    const std::size_t k = i;  // the same cells and ids while both are at rest
    if (awakeOnes.particles().id[k] != x.particles().id[i]) continue;
    EXPECT_LT(length(awakeOnes.particles().position[k] - x.particles().position[i]), 0.01 * s.spacing);
  }
  const LedgerReport ledgerReport = x.ledgerReport();
  EXPECT_LT(std::abs(ledgerReport.energyResidual - awakeOnes.ledgerReport().energyResidual),
            1e-3 * ledgerReport.energyScale);
  EXPECT_LT(length(ledgerReport.momentumResidual), 1e-6 * ledgerReport.now.mass);
}

TEST(Sleep, FallingBlockWakesOnlyTheBlockItHits) {
  Scene s = blocks(4);
  s.numerics.sleepSpeed = 0.02;
  s.numerics.sleepAfter = 0.02;
  test::Simulation x(s);
  bool slept = false, hit = false;
  while (x.w.clock.time < 1.1) {
    ASSERT_TRUE(x.step());
    const double fast = lowest(x.particles(), 1);
    bool below = true, far = true;
    for (std::size_t i = 0; i < x.particles().owned; i++) {
      if (x.particles().body[i] == 0) below = below && x.particles().sleep[i] != awake;
      if (x.particles().body[i] == 2) far = far && x.particles().sleep[i] != awake;
    }
    if (fast > 0.9) slept = slept || (below && far);
    if (slept && !below && far) hit = true;
  }
  EXPECT_TRUE(slept);
  EXPECT_TRUE(hit);
}

/// Number of sleeping particles of a body.
std::size_t sleepers(const Continuum& p, std::uint16_t body) {
  std::size_t n = 0;
  for (std::size_t i = 0; i < p.owned; i++) n += p.body[i] == body && p.sleep[i] != awake;
  return n;
}

TEST(Sleep, NoBlockSleepsInTheAir) {
  Scene s = blocks(4);
  s.numerics.sleepSpeed = 1;  // free fall reaches it after 0.1 s; sleep_after is 0.05 s
  s.end = 1;
  test::Simulation x(s);
  while (x.w.clock.time < 0.3) {
    ASSERT_TRUE(x.step());
    ASSERT_EQ(sleepers(x.particles(), 1), 0u) << x.w.clock.time;
  }
  EXPECT_NEAR(lowest(x.particles(), 1), 4.7 - 0.5 * 9.81 * x.w.clock.time * x.w.clock.time, 0.01);
}

TEST(Sleep, PushingWallWakesOnlyThePushedBlock) {
  Scene s = blocks(4);
  s.numerics.sleepSpeed = s.numerics.sleepAfter = 0.02;
  s.bodies.erase(s.bodies.begin() + 1);
  s.obstacles.emplace_back();
  s.obstacles.back().name = "ram";
  s.obstacles.back().shape.size = {0.4, 1, 0.6};
  s.obstacles.back().shape.move = {-1.2, 0, 0.4};
  s.obstacles.back().motion = {{1.0, {0, 0, 0}, {}}, {1.4, {0.8, 0, 0}, {}}};
  test::Simulation x(s);
  bool slept = false, woken = false;
  while (x.w.clock.time < 1.35) {
    ASSERT_TRUE(x.step());
    const std::size_t near = sleepers(x.particles(), 0), far = sleepers(x.particles(), 1);
    if (x.w.clock.time > 0.9 && x.w.clock.time < 1 && near > 0 && far > 0) slept = true;
    if (slept && x.w.clock.time > 1.3) {
      woken = near == 0;
      EXPECT_GT(far, 0u);
      break;
    }
  }
  EXPECT_TRUE(slept);
  EXPECT_TRUE(woken);
}

TEST(Sleep, HeatWakes) {
  Scene s = blocks(4);
  s.numerics.sleepSpeed = s.numerics.sleepAfter = 0.02;
  s.bodies.erase(s.bodies.begin() + 1);
  s.materials[0].conductivity = {1, 1};
  s.thermostats.push_back({});
  s.thermostats.back().start = 1;
  s.thermostats.back().over = 0.1;
  s.thermostats.back().temperature = 400;
  test::Simulation x(s);
  bool slept = false, woken = false;
  while (x.w.clock.time < 1.3) {
    ASSERT_TRUE(x.step());
    const std::size_t n = sleepers(x.particles(), 0);
    if (x.w.clock.time < 1) slept = slept || n > 0;
    if (x.w.clock.time > 1.02 && x.w.clock.time < 1.09) woken = woken || n == 0;
  }
  EXPECT_TRUE(slept);
  EXPECT_TRUE(woken);
  // and all particles are awake and warmed
  for (std::size_t i = 0; i < x.particles().owned; i++) ASSERT_NEAR(x.particles().temperature[i], 400, 0.5);
}

}  // namespace
}  // namespace thaw
