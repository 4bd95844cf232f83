// SPDX-License-Identifier: Apache-2.0
// Liquids and solids on walls over whole steps, against exact solutions.
#include <gtest/gtest.h>

#include <cmath>

#include "core/fluid/laws/particle_pressure.hpp"
#include "tests/support/flows.hpp"

namespace thaw::test {

TEST(LiquidAtWalls, HydrostaticColumn) {
  const double dx = 0.1, H = 10 * dx;
  Scene s = columnScene(dx, 0, 16 * dx);
  s.domain.side[2][0] = Side::Wall;
  s.domain.gravity = {0, 0, -10};
  s.materials[0].soundSpeed = 10 * std::sqrt(10 * H);
  s.materials[0].viscosity = {500, 500};
  addBox(s, {0, 0, 0}, {6 * dx, 6 * dx, H});
  s.end = 2;
  Simulation run(s);
  EXPECT_TRUE(run.run());
  const Continuum& p = run.particles();
  double square = 0, fastest = 0;
  for (std::size_t i = 0; i < p.owned; i++) {
    const double exact = 1000 * 10 * (H - p.position[i].z);
    square += std::pow((static_cast<double>(pressureOfParticle(run.w.scene, run.w.modules, run.w.particles,
                                                               run.tools.liquids, i)) -
                        exact) /
                           (1000 * 10 * H),
                       2);
    fastest = std::max(fastest, length(p.velocity[i]));
    EXPECT_GT(p.position[i].z, 0.2 * dx);
  }
  EXPECT_LT(std::sqrt(square / static_cast<double>(p.owned)), 0.08);
  EXPECT_LT(fastest, 0.02 * std::sqrt(10 * H));
  EXPECT_EQ(run.w.counters.wallProjections, 0);
  const LedgerReport r = run.ledgerReport();
  EXPECT_EQ(r.massResidual, 0);
  EXPECT_LT(length(r.momentumResidual), 1e-6 * length(r.gravityImpulse));
}

// Water of low viscosity in a box starts from a lattice, settles and stays at rest. The walls do not move, so
// they do no work.
TEST(LiquidAtWalls, WaterAtRestStaysAtRest) {
  Scene s = liquidInABox(0.004, {0.032, 0.032, 0.1}, {0.032, 0.032, 0.048}, 0.01);
  s.end = 0.5;
  Simulation run(s);
  EXPECT_TRUE(run.run());
  const LedgerReport r = run.ledgerReport();
  EXPECT_EQ(r.wallWork, 0);
  EXPECT_LT(r.now.kinetic, 1e-3 * r.initial.potential);
  EXPECT_LT(std::abs(r.energyResidual), 1e-3 * r.initial.potential);
}

/// A tank cut out of one obstacle holds water at rest as the sides of the domain do.
TEST(LiquidAtWalls, TankCutOutOfAnObstacleActsLikeDomainSides) {
  const auto restOf = [](bool cut) {
    Scene s = liquidInABox(0.004, {0.032, 0.032, 0.1}, {0.032, 0.032, 0.032}, 0.001);
    s.materials[0].artificialViscosity = 0.02;
    s.end = 0.3;
    if (cut) {
      for (auto& side : s.domain.side) side = {Side::Open, Side::Open};
      for (int a = 0; a < 3; a++) s.domain.min[a] -= 0.02, s.domain.max[a] += 0.02;
      Obstacle tank;
      tank.shape.kind = ShapeKind::Difference;
      tank.shape.parts.resize(2);
      tank.shape.parts[0].kind = tank.shape.parts[1].kind = ShapeKind::Box;
      tank.shape.parts[0].size = {0.06, 0.06, 0.14};
      tank.shape.parts[0].move = {0.016, 0.016, 0.05};
      tank.shape.parts[1].size = {0.032, 0.032, 0.2};
      tank.shape.parts[1].move = {0.016, 0.016, 0.1};
      s.obstacles.push_back(tank);
    }
    Simulation run(s);
    EXPECT_TRUE(run.run());
    return run.ledgerReport();
  };
  const LedgerReport sides = restOf(false), tank = restOf(true);
  EXPECT_LT(tank.now.kinetic, 1e-3 * tank.initial.potential);
  EXPECT_NEAR(tank.now.potential - tank.initial.potential, sides.now.potential - sides.initial.potential,
              1e-3 * std::abs(sides.initial.potential));
  EXPECT_LT(std::abs(tank.energyResidual), 1e-3 * std::abs(sides.initial.potential));
}

TEST(LiquidAtWalls, PoiseuilleBetweenPlates) {
  const PlateFlow flow;
  Simulation run(flow.scene());
  EXPECT_TRUE(run.run());
  EXPECT_LT(flow.error(run.particles()), 0.05);
}

TEST(LiquidAtWalls, LiquidInsideAnObstacleIsMovedOut) {
  Scene s = columnScene(0.1, -1, 2);
  s.domain.gravity = {0, 0, -10};
  s.materials[0].soundSpeed = 20;
  s.numerics.overlap = OverlapRule::Keep;
  addBox(s, {0, 0, -0.2}, {0.6, 0.6, 0.4});
  addFloor(s);
  Simulation run(s);
  EXPECT_GT(run.w.counters.wallProjections, 0);
  for (int k = 0; k < 20; k++) ASSERT_TRUE(run.step());
  for (std::size_t i = 0; i < run.particles().owned; i++) EXPECT_GT(run.particles().position[i].z, -0.06);
}

TEST(SolidAtWalls, BlockOnASlope) {
  for (const double angle : {0.2, 0.5}) {  // the friction angle is atan 0.3 = 0.29
    const double dx = 0.1, g = 10, mu = 0.3;
    Scene s;
    s.spacing = dx;
    s.domain.min = {-1, -1, -1};
    s.domain.max = {3, 1, 1};
    s.domain.gravity = {g * std::sin(angle), 0, -g * std::cos(angle)};
    s.output.every = 0;
    s.materials.emplace_back();
    Material& m = s.materials[0];
    m.young = {1e6, 1e6};
    m.damping = 20;
    m.restitution = 0.2;
    addBox(s, {-2 * dx, -2 * dx, 0}, {2 * dx, 2 * dx, 3 * dx});
    addFloor(s).friction = mu;
    s.obstacles[0].restitution = 0.2;
    s.end = 0.4;
    Simulation run(s);
    EXPECT_TRUE(run.run());
    const LedgerReport r = run.ledgerReport();
    const double speed = r.now.momentum.x / r.now.mass,
                 slide = g * (std::sin(angle) - mu * std::cos(angle)) * s.end;
    if (slide > 0) EXPECT_NEAR(speed, slide, 0.05 * slide);
    else EXPECT_LT(std::abs(speed), 0.02);
    EXPECT_LT(length(r.momentumResidual), 1e-6 * length(r.gravityImpulse));
    EXPECT_LT(std::abs(r.energyResidual), 0.02 * r.energyScale);
  }
}

}  // namespace thaw::test
