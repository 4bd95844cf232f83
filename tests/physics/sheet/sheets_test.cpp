// SPDX-License-Identifier: Apache-2.0
// Sheets in a whole simulation: exact motion, forces from energies, plastic flow, energy budget.
#include <gtest/gtest.h>

#include <cmath>

#include "core/sheet/step_sheets.hpp"
#include "tests/support/sheet_samples.hpp"

namespace thaw {
namespace {

using test::expectForcesFromEnergy, test::sheetScene;

TEST(Sheets, StepsOfAnyLengthAreExactWhereForcesAreConstant) {
  for (const double dt : {0.5, 0.125, 0.01}) {
    Scene s = sheetScene(SheetMesh::Grid);
    s.domain.gravity = {0.3, 0, -1};
    s.sheets[0].stiffness = 30;
    s.sheets[0].damping = 1.2;
    s.end = 1;
    s.numerics.fixedStep = dt;
    s.numerics.retryEvery = 0;
    test::Simulation sim(s);
    ASSERT_TRUE(sim.run());
    const Sheets& v = sim.w.sheets.rows;
    ASSERT_EQ(v.owned, 121u);
    // relative to the start below the rest position under load
    const double a = 1.2 / (2 * 0.5), w = std::sqrt(30 / 0.5 - a * a), z0 = 0.5 * 1 / 30.0;
    const double z = z0 * std::exp(-a) * (std::cos(w) + a / w * std::sin(w)) - z0;
    for (std::size_t i = 0; i < v.owned; i++) {
      EXPECT_NEAR(v.position[i].z - v.rest[i].z, z, 1e-13);
      EXPECT_NEAR(v.position[i].x - v.rest[i].x, -0.3 * z, 1e-13);
    }
    const LedgerReport ledgerReport = sim.ledgerReport();
    EXPECT_NEAR(ledgerReport.energyResidual, 0, 1e-13 * ledgerReport.energyScale);
    EXPECT_NEAR(length(ledgerReport.momentumResidual), 0, 1e-14);
  }
}

TEST(Sheets, ForcesAreGradientsOfEnergies) {
  Scene s = sheetScene(SheetMesh::Grid);
  SheetBody& b = s.sheets[0];
  b.warp = 30, b.weft = 12, b.shear = 4, b.bending = 2;
  b.stretchLimit = 1.02;
  expectForcesFromEnergy(s);
  s = sheetScene(SheetMesh::Sphere);
  s.sheets[0].volumeStiffness = 500;
  s.sheets[0].warp = s.sheets[0].weft = s.sheets[0].shear = 10;
  expectForcesFromEnergy(s);
}

/// A stretched net that is released oscillates at the scale of its mesh, the worst case for the energy
/// budget. Leap-frog conserves a modified energy (HLW06, IX.3), which differs by dt^2 (v U'' v / 12 - f^2 /
/// 24 m). The residual equals that difference up to fourth order, so no entry is missing.
TEST(Sheets, SpringResidualIsTheLeapFrogEnergy) {
  double worst[2];
  for (const bool half : {false, true}) {
    Scene s = test::emptyScene(0.05, {-2, -2, -2}, {2, 2, 2});
    s.sheets.emplace_back();
    SheetBody& b = s.sheets[0];
    b.name = "net";
    b.width = b.depth = 1;
    b.spacing = 0.1;
    b.mass = 0.5;
    b.warp = b.weft = 100, b.shear = 20;
    b.restLength = 0.9;
    s.end = 0.5;
    const double dt = s.numerics.fixedStep = half ? 0.0015 : 0.003;
    s.numerics.retryEvery = 0;
    test::Simulation sim(s);
    const auto loads = [&] {
      const Sheets& v = sim.w.sheets.rows;
      std::vector<Vec3d> all(v.owned);
      for (std::size_t i = 0; i < v.owned; i++) all[v.id[i]] = v.area[i] * v.load[i];
      return all;
    };
    std::vector<Vec3d> before = loads(), now = before;
    std::vector<double> mass(now.size());
    double missing = 0, unexplained = 0, scale = 0;
    worst[half] = 0;
    for (std::size_t i = 0; i < mass.size(); i++) mass[sim.w.sheets.rows.id[i]] = sim.w.sheets.rows.mass[i];
    const auto squares = [&](const std::vector<Vec3d>& f) {
      double sum = 0;
      for (std::size_t i = 0; i < f.size(); i++) sum += dot(f[i], f[i]) / mass[i];
      return sum;
    };
    const double start = -squares(now) * dt * dt / 24;
    std::vector<Vec3d> velocity(now.size());
    while (sim.w.clock.time < s.end) {
      ASSERT_TRUE(sim.step());
      const std::vector<Vec3d> after = loads();
      double swing = 0;  // v U'' v at the middle of three states, as for velocity and residual
      for (std::size_t i = 0; i < now.size(); i++) swing -= dot(velocity[i], after[i] - before[i]) / (2 * dt);
      if (sim.w.clock.step > 2)
        unexplained = std::max(unexplained,
                               std::abs(missing - (start - dt * dt * (swing / 12 - squares(now) / 24))));
      const LedgerReport ledgerReport = sim.ledgerReport();
      missing = ledgerReport.energyResidual;
      scale = std::max(scale, ledgerReport.energyScale);
      worst[half] = std::max(worst[half], std::abs(missing));
      for (std::size_t i = 0; i < velocity.size(); i++)
        velocity[sim.w.sheets.rows.id[i]] = sim.w.sheets.rows.velocity[i];
      before = now;
      now = after;
    }
    EXPECT_LT(unexplained, (half ? 0.03 : 0.1) * worst[half]);
    worst[half] /= scale;
  }
  EXPECT_LT(worst[0], 0.025);  // near the default step
  EXPECT_NEAR(worst[0] / worst[1], 4, 0.5);
}

/// Leaving vertices take their mass along. The remaining mesh is open and has no pressure.
TEST(Sheets, BallThatLosesVerticesLosesItsPressure) {
  Scene s = sheetScene(SheetMesh::Sphere);
  SheetBody& b = s.sheets[0];
  b.volumeStiffness = 500;
  b.warp = b.weft = b.shear = 10;
  b.velocity = {3, 0, 0};
  s.domain.gravity = {};
  s.end = 1;
  s.numerics.retryEvery = 0;
  test::Simulation sim(s);
  const std::size_t whole = sim.w.sheets.rows.owned;
  ASSERT_TRUE(sim.run());
  const LedgerReport ledgerReport = sim.ledgerReport();
  EXPECT_LT(sim.w.sheets.rows.owned, whole);
  EXPECT_LT(std::abs(ledgerReport.energyResidual), 0.01 * ledgerReport.energyScale);
  EXPECT_LT(length(ledgerReport.momentumResidual), 1e-9);
}

/// A brush that crosses the sheet in one step, or acts for part of one, has the same effect as in many short
/// steps.
TEST(Sheets, BrushesActAlongTheirPathInStepsOfAnyLength) {
  for (const bool moves : {true, false}) {
    std::vector<double> speed[2];
    for (int k = 0; k < 2; k++) {
      Scene s = sheetScene(SheetMesh::Grid);
      PressureBrush brush;
      brush.centre = {moves ? -2.0 : 0.05, 0.05, 0};
      brush.radius = 0.15;  // for a path of 4 m in 0.1 s and steps of 0.05 s
      brush.pressure = {0, 0, -3};
      if (moves) brush.motion = {{0.1, {}, {}}, {0.2, {4, 0, 0}, {}}};
      else brush.inTime.points = {{0.11, 0}, {0.115, 2}, {0.12, 0}};
      s.sheets[0].pressureBrushes.push_back(brush);
      s.end = 0.4;
      s.numerics.fixedStep = k == 0 ? 0.05 : 1e-4;
      s.numerics.retryEvery = 0;
      test::Simulation sim(s);
      ASSERT_TRUE(sim.run());
      const Sheets& v = sim.w.sheets.rows;
      speed[k].assign(v.owned, 0);
      for (std::size_t i = 0; i < v.owned; i++) speed[k][v.id[i]] = v.velocity[i].z;
    }
    double most = 0;
    for (const double v : speed[1]) most = std::max(most, -v);
    EXPECT_GT(most, 0.001);
    for (std::size_t i = 0; i < speed[0].size(); i++)
      EXPECT_NEAR(speed[0][i], speed[1][i], 0.01 * most) << moves << " " << i;
  }
}

TEST(Sheets, PlasticityKeepsItsShareOfTheExcess) {
  for (const double plasticity : {0.0, 0.25, 0.5, 1.0})
    for (const double dt : plasticity == 1 ? std::vector{0.1, 0.013, 0.0013} : std::vector{0.1, 0.013}) {
      Scene s = sheetScene(SheetMesh::Grid);
      SheetBody& b = s.sheets[0];
      b.mass = 0.01;
      b.stiffness = 100;
      b.damping = 10;
      b.plasticity = plasticity;
      b.elasticLimit = 0.02;
      // 5 cm by the spring alone
      b.pressureBrushes.push_back({{}, {}, 1e6, {0, 0, -5}, {{{0, 0}, {1, 1}, {7, 1}, {7.1, 0}}}, {}});
      s.end = 11;
      s.numerics.fixedStep = dt;
      s.numerics.retryEvery = 0;
      test::Simulation sim(s);
      ASSERT_TRUE(sim.run());
      const Sheets& v = sim.w.sheets.rows;
      // The load stretches the spring to 5 cm, whatever its rest position: limit + (1 - p) excess. With p = 1
      // it never reaches that: the spring gives 2 N/m^2 at its limit. The rest of the load flows against the
      // damping as long as it acts, and that stretch stays. The spring resists within a step, so less flows
      // in long steps. The exact step gives a flow of 3 Pa beyond the limit from 1 s to 7 s. The parts of
      // both ramps beyond it are added.
      const double flowing = (3 * 6 + 0.5 * 3 * (3.0 / 5) * (1 + 0.1)) / b.damping;
      const double swing = b.stiffness * dt / b.damping, inSteps = -std::expm1(-swing) / swing;
      const double left = plasticity == 1 ? flowing * inSteps : plasticity * (0.05 - 0.02) / (1 - plasticity);
      for (std::size_t i = 0; i < v.owned; i += 10)
        EXPECT_NEAR(v.rest[i].z - v.position[i].z, left, plasticity == 1 ? 0.003 * left : 2e-5)
            << plasticity << " " << dt;
      if (plasticity == 1 && dt < 0.002) { EXPECT_NEAR(left, flowing, 0.01 * flowing); }
    }
}

// Light vertices without springs in a wind: the drag limits the step, and they reach the wind's speed without
// overshoot.
TEST(Sheets, WindDragsLightVerticesToItsSpeed) {
  Scene s = test::emptyScene(0.02, {-1, -1, -1}, {1, 1, 1});
  SheetBody b;
  b.name = "leaf";
  b.mesh = SheetMesh::Grid;
  b.width = b.depth = 0.3;
  b.spacing = 0.02;
  b.mass = 0.01;
  b.windDensity = 1.2;
  b.wind = {0, 0, 1};
  s.sheets.push_back(b);
  s.end = 0.5;
  test::Simulation x(s);
  ASSERT_TRUE(x.run());
  EXPECT_EQ(x.w.counters.left, 0);
  const Sheets& v = x.w.sheets.rows;
  for (std::size_t i = 0; i < v.owned; i++) {
    EXPECT_GT(v.velocity[i].z, 0.7);
    EXPECT_LT(v.velocity[i].z, 1.0);
  }
}

/// At rest there is no drag. The first step must be short enough that the drag at its end does not reverse
/// the motion.
TEST(Sheets, FallsFromRestToTerminalSpeed) {
  Scene s = sheetScene(SheetMesh::Grid);
  s.domain.min.z = -20;
  s.domain.gravity = {0, 0, -9.81};
  SheetBody& b = s.sheets[0];
  b.mass = 0.01;
  b.windDensity = 1.2;
  s.output.every = 0.5;
  s.end = 2;
  test::Simulation x(s);
  const double terminal = std::sqrt(0.01 * 9.81 / 1.2);
  while (x.w.clock.time < s.end) {
    ASSERT_TRUE(x.step());
    const Sheets& v = x.w.sheets.rows;
    for (std::size_t i = 0; i < v.owned; i++) ASSERT_LT(std::abs(v.velocity[i].z), 1.3 * terminal);
    const LedgerReport ledgerReport = x.ledgerReport();
    ASSERT_LT(std::abs(ledgerReport.energyResidual), 0.3 * ledgerReport.energyScale);
  }
  for (std::size_t i = 0; i < x.w.sheets.rows.owned; i++)
    EXPECT_NEAR(x.w.sheets.rows.velocity[i].z, -terminal, 0.01 * terminal);
  const LedgerReport ledgerReport = x.ledgerReport();
  EXPECT_LT(std::abs(ledgerReport.energyResidual), 0.01 * ledgerReport.energyScale);
}

TEST(Sheets, LedgerClosesForAClothThatFallsOnFloorAndItself) {
  Scene s = sheetScene(SheetMesh::Grid);
  s.spacing = 0.025;
  s.domain.gravity = {0, 0, -9.81};
  test::addFloor(s);
  SheetBody& b = s.sheets[0];
  b.width = b.depth = 0.6;
  b.spacing = 0.05;
  b.shape.rotate = {1.2, 0.1, 0};
  b.shape.move = {0, 0, 0.4};
  b.warp = b.weft = 60, b.shear = 5, b.bending = 0.3;
  b.damping = 0.2;
  b.selfContact = true;
  s.end = 0.4;
  test::Simulation sim(s);
  ASSERT_TRUE(sim.run());
  const LedgerReport ledgerReport = sim.ledgerReport();
  EXPECT_LT(std::abs(ledgerReport.energyResidual), 0.02 * ledgerReport.energyScale);
  EXPECT_LT(length(ledgerReport.momentumResidual), 1e-12);
  EXPECT_NEAR(ledgerReport.now.mass, 0.5 * 0.36, 1e-12);
}

TEST(Sheets, CostNothingInScenesWithoutSheets) {
  Scene s;
  s.spacing = 0.1;
  s.materials.emplace_back();
  s.materials[0].name = "water";
  test::addBox(s, {-0.3, -0.3, -0.3}, {0.3, 0.3, 0.3});
  test::Simulation sim(s);
  for (const AnyColumn* c : sim.w.sheets.rows.columns) EXPECT_FALSE(c->active);
  EXPECT_TRUE(sim.w.sheets.plans.empty());
  EXPECT_FALSE(sim.w.modules.sheet);
}

}  // namespace
}  // namespace thaw
