// SPDX-License-Identifier: Apache-2.0
// Drag of a mush beside a solid against the exact decay.
#include <gtest/gtest.h>

#include <cmath>

#include "core/heat/mush.hpp"
#include "tests/support/simulation.hpp"

namespace thaw::test {
namespace {

constexpr double dx = 0.01, speed = 1e-3;

/// Liquid at 333 K (fraction 0.8) that slides over a clamped solid of the same material.
Scene slidingMelt(double drag) {
  Scene s = columnScene(dx, -2 * dx, 8 * dx);
  s.materials[0] = wax();
  Material& m = s.materials[0];
  m.name = "wax";
  m.viscosity = {0, 0};
  m.conductivity = {0, 0};
  m.damping = 0;
  m.hysteresis = 0.35;  // liquid down to a fraction of 0.35, solid up to 0.65
  m.soundSpeed = 0.05;  // so that the forces of the lattice below are small
  m.mushDrag = drag;
  addBox(s, {0, 0, 0}, {6 * dx, 6 * dx, 3 * dx}).temperature = 300;
  s.bodies[0].clamp = {s.bodies[0].shape};
  Body& melt = addBox(s, {0, 0, 3 * dx}, {6 * dx, 6 * dx, 4 * dx});
  melt.temperature = 333;
  melt.velocity = {speed, 0, 0};
  s.thermostats.emplace_back();  // enables heat; starts after the end of the scene
  s.thermostats[0].start = 1e3;
  s.end = 0.05;
  return s;
}

}  // namespace

TEST(Mush, StopsLiquidBesideASolidAtItsRate) {
  Scene s = slidingMelt(4e5);
  Simulation run(s);
  ASSERT_TRUE(run.w.modules.mushDrag);
  Continuum& p = run.particles();
  const double f = static_cast<double>(p.liquid[p.owned - 1]);
  ASSERT_GT(f, 0.5);
  const double rate = mushRateOf(s.materials[0], f);
  EXPECT_DOUBLE_EQ(rate, 4e5 * (1 - f) * (1 - f) / ((f * f * f + 1e-3) * 900));
  const auto fastest = [&] {
    double most = 0;
    for (std::size_t i = 0; i < p.owned; i++) most = std::max(most, p.velocity[i].x);
    return most;
  };
  for (int k = 0; k < 3; k++) ASSERT_TRUE(run.step());  // it melts in the first
  const double from = run.w.clock.time, atFirst = fastest();
  ASSERT_TRUE(run.run());
  const LedgerReport r = run.ledgerReport();
  const double decay = std::exp(-rate * (run.w.clock.time - from));
  EXPECT_LT(decay, 0.3);
  EXPECT_NEAR(fastest() / (atFirst * decay), 1, 5e-3);
  EXPECT_LT(std::abs(r.energyResidual), 1e-3 * r.initial.kinetic);
  EXPECT_LT(std::abs(r.momentumResidual.x), 1e-12 * r.initial.momentum.x);
}

TEST(Mush, ALargeDragNeedsNoShortStep) {
  Simulation none(slidingMelt(0));
  Simulation huge(slidingMelt(1e12));
  ASSERT_TRUE(none.run() && huge.run());
  EXPECT_FALSE(none.w.modules.mushDrag);
  EXPECT_NEAR(huge.shortest / none.shortest, 1, 0.05);
  for (std::size_t i = 0; i < huge.particles().owned; i++)
    EXPECT_LT(length(huge.particles().velocity[i]), 1e-3 * speed);
  EXPECT_NEAR(huge.ledgerReport().dissipated / huge.ledgerReport().initial.kinetic, 1, 1e-3);
}

TEST(Mush, FloatingCrystalsMoveWithTheLiquid) {
  Scene s = slidingMelt(1e6);
  s.bodies.erase(s.bodies.begin());
  Simulation run(s);
  ASSERT_TRUE(run.run());
  for (std::size_t i = 0; i < run.particles().owned; i++)
    EXPECT_NEAR(run.particles().velocity[i].x, speed, 1e-6 * speed);
}

}  // namespace thaw::test
