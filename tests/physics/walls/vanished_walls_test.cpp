// SPDX-License-Identifier: Apache-2.0
// Obstacles that vanish: the ledger records the energy that particles gain or lose.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/simulation.hpp"

namespace thaw::test {
namespace {

constexpr double degree = std::numbers::pi / 180;

/// A cube of eight particles a side on a floor that vanishes at half of the time.
Scene cubeOnFloor(double spacing, double end) {
  const double side = 8 * spacing;
  Scene s = emptyScene(spacing, {-2 * side, -2 * side, -2 * side}, {2 * side, 2 * side, 2 * side});
  s.materials.emplace_back();
  addBox(s, {-side / 2, -side / 2, 0}, {side / 2, side / 2, side / 2});
  s.end = end;
  addFloor(s).until = 0.5 * end;
  return s;
}

/// Changes in the step in which the floor vanishes (J).
struct Jump {
  double work = 0, residual = 0;
};

Jump jumpOf(const Scene& s) {
  Simulation run(s);
  LedgerReport before;
  while (run.w.walls.list[0].present && run.w.clock.time < s.end) {
    before = run.ledgerReport();
    EXPECT_TRUE(run.step());
  }
  const LedgerReport after = run.ledgerReport();
  EXPECT_FALSE(run.w.walls.list[0].present);
  return {after.wallWork - before.wallWork, after.energyResidual - before.energyResidual};
}

}  // namespace

TEST(VanishedWalls, LedgerHasTheEnergyOfExposedSurfaces) {
  for (const double angle : {40.0, 90.0, 130.0}) {
    SCOPED_TRACE(angle);
    Scene s = cubeOnFloor(1e-3, 0.02);
    s.materials[0].viscosity = {0.02, 0.02};
    s.materials[0].surfaceTension = 0.07;
    s.obstacles[0].contactAngle = angle * degree;
    const Jump jump = jumpOf(s);
    EXPECT_GT(jump.work, 0);
    EXPECT_LT(std::abs(jump.residual), 0.05 * std::abs(jump.work));
  }
}

TEST(VanishedWalls, LedgerHasTheEnergyOfReleasedSprings) {
  Scene s = cubeOnFloor(1e-2, 0.4);
  s.domain.gravity = {0, 0, -9.81};
  s.materials[0].young = {2e4, 0};
  s.materials[0].damping = 4;
  const Jump jump = jumpOf(s);
  EXPECT_LT(jump.work, 0);
  EXPECT_LT(std::abs(jump.residual), 0.05 * std::abs(jump.work));
}

// Solids that froze close to an obstacle have shorter springs while it is near.
TEST(VanishedWalls, LedgerHasTheEnergyOfSpringsOfFrozenSolids) {
  Scene s = cubeOnFloor(1e-2, 0.4);
  s.domain.gravity = {0, 0, -9.81};
  s.bodies[0].shape = boxOf({-0.04, -0.04, -0.002}, {0.04, 0.04, 0.078});
  Material& m = s.materials[0];
  m.young = {2e4, 0};
  m.damping = 4;
  m.solidus = m.liquidus = 350;
  m.latentHeat = 1e5;
  m.conductivity = {0.2, 0.2};
  s.obstacles[0].temperature = 300;
  addFloor(s).shape.point = {0, 0, -0.1};
  const Jump jump = jumpOf(s);
  EXPECT_LT(jump.work, 0);
  EXPECT_LT(std::abs(jump.residual), 0.05 * std::abs(jump.work));
}

TEST(VanishedWalls, LedgerHasTheCompressionEnergyOfSummedDensities) {
  Scene s = cubeOnFloor(1e-2, 0.4);
  s.domain.gravity = {0, 0, -9.81};
  s.domain.side[0] = s.domain.side[1] = {Side::Periodic, Side::Periodic};
  s.bodies[0].shape = boxOf({-0.16, -0.16, 0}, {0.16, 0.16, 0.08});
  s.numerics.density = DensityForm::Summation;
  s.materials[0].viscosity = {1, 1};
  s.materials[0].artificialViscosity = 2;
  s.materials[0].soundSpeed = 3;
  const Jump jump = jumpOf(s);
  EXPECT_LT(jump.work, 0);
  EXPECT_LT(std::abs(jump.residual), 0.05 * std::abs(jump.work));
}

}  // namespace thaw::test
