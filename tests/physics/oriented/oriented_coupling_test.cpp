// SPDX-License-Identifier: Apache-2.0
// Coupling of oriented bodies with constraints, sheets, the continuum, obstacles and open sides: momentum and
// energy budget.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/oriented_samples.hpp"

namespace thaw {
namespace {

using test::patchScene;

// A constraint acts until the end of the step in which it is released. The impulse of this step belongs to
// the constraint.
TEST(Oriented, ReleasedConstraintsUnderLoadKeepTheLedgerClosed) {
  for (const auto how : {OrientedIntegrator::SymplecticEuler, OrientedIntegrator::RungeKutta,
                         OrientedIntegrator::SemiImplicit}) {
    Scene s = patchScene(0);
    s.domain.gravity = {0, 0, -9.81};
    OrientedBody& b = s.oriented[0];
    b.integrator = how;
    b.damping = 2;
    b.pressure = 3;
    b.acceleration = {0.5, 0.2, 0};
    OrientedConstraint edge;
    edge.region = test::boxOf({-0.3, -0.3, -0.1}, {-0.15, 0.3, 0.1});
    edge.motion = {{0, {}, {}}, {0.04, {0.01, 0, 0.02}, {0.1, 0, 0}}};
    edge.until = 0.05;
    b.constraints.push_back(edge);
    test::addFloor(s).shape.move = {0, 0, -0.02};
    s.end = 0.1;
    test::Simulation x(s);
    ASSERT_TRUE(x.run());
    const LedgerReport r = x.ledgerReport();
    EXPECT_GT(length(r.gravityImpulse), 0);
    EXPECT_LT(length(r.momentumResidual), 1e-12 * length(r.gravityImpulse)) << static_cast<int>(how);
  }
}

// A constraint that turns normals bends the patch. The constraint works through torques only.
TEST(Oriented, LedgerRecordsWorkOfNormalConstraints) {
  for (const auto how : {OrientedIntegrator::SymplecticEuler, OrientedIntegrator::RungeKutta}) {
    Scene s = patchScene(0);
    OrientedBody& b = s.oriented[0];
    b.integrator = how;
    b.cfl = 0.1;
    b.facing = false;
    OrientedConstraint edge;
    edge.region = test::boxOf({-0.3, -0.3, -0.1}, {-0.15, 0.3, 0.1});
    edge.position = false;
    edge.normal = true;
    edge.motion = {{0, {}, {}}, {0.2, {}, {0, 0.5, 0}}};
    b.constraints.push_back(edge);
    s.end = 0.2;
    test::Simulation x(s);
    ASSERT_TRUE(x.run());
    const LedgerReport r = x.ledgerReport();
    const double change = r.now.kinetic + r.now.elastic - r.initial.elastic;
    std::printf("work %.3e J, energy %.3e J more, residual %.1e J\n", r.wallWork, change, r.energyResidual);
    EXPECT_GT(change, 0);
    EXPECT_LT(std::abs(r.energyResidual), 0.02 * change) << static_cast<int>(how);
  }
}

TEST(Oriented, SheetPatchContactConservesMomentumAndEnergy) {
  Scene s = patchScene(0);
  s.oriented[0].density = 2;
  SheetBody sheet;
  sheet.name = "cloth";
  sheet.mesh = SheetMesh::Grid;
  sheet.width = sheet.depth = 0.4;
  sheet.spacing = 0.04;
  sheet.shape.move = {0.01, 0.02, 0.06};
  sheet.mass = 1;
  sheet.velocity = {0.1, 0, -0.5};
  sheet.friction = 0.3;
  s.sheets.push_back(sheet);
  s.numerics.maxStep = 2e-4;
  s.end = 0.3;
  test::Simulation x(s);
  const LedgerReport before = x.ledgerReport();
  double impulseInFlight = 0;
  while (x.w.clock.time < s.end) {
    ASSERT_TRUE(x.step());
    if (x.w.clock.step % 50 == 0)
      impulseInFlight = std::max(impulseInFlight, length(x.ledgerReport().impulseInFlight));
  }
  const LedgerReport after = x.ledgerReport();
  double patch = 0;
  const Oriented& o = x.w.oriented.rows;
  for (std::size_t i = 0; i < o.owned; i++) patch += o.mass[i] * o.velocity[i].z;
  EXPECT_LT(patch, 0.2 * before.now.momentum.z);  // most of the way down together
  // Contact applies its impulses by halves to vertices and at once to oriented particles. The impulse in
  // flight is part of the sum; steps that grow or shrink do not change it.
  EXPECT_GT(impulseInFlight, 1e-6 * length(before.now.momentum));
  EXPECT_LT(length(after.now.momentum + after.impulseInFlight - before.now.momentum),
            1e-12 * length(before.now.momentum));
  EXPECT_LT(std::abs(after.energyResidual), 0.01 * before.now.kinetic);
}

TEST(Oriented, BodyPatchContactConservesMomentum) {
  for (const auto how : {OrientedIntegrator::SymplecticEuler, OrientedIntegrator::RungeKutta,
                         OrientedIntegrator::SemiImplicit}) {
    Scene s = patchScene(0);
    s.oriented[0].integrator = how;
    s.oriented[0].density = 5;
    s.materials.emplace_back();
    s.materials[0].name = "jelly";
    s.materials[0].density = 200;
    s.materials[0].young = {2e3, 2e3};
    test::addBox(s, {-0.1, -0.1, 0.06}, {0.15, 0.1, 0.16}).velocity = {0.2, 0, -1};
    s.end = 0.15;
    test::Simulation x(s);
    ASSERT_TRUE(x.run());
    const LedgerReport r = x.ledgerReport();
    EXPECT_GT(r.dissipated, 0);
    EXPECT_LT(length(r.momentumResidual), 1e-12 * length(r.initial.momentum)) << static_cast<int>(how);
    EXPECT_LT(std::abs(r.energyResidual), 0.02 * r.energyScale) << static_cast<int>(how);
  }
}

// Impulse and work of a moving obstacle that disappears are those of its position when the forces were
// computed.
TEST(Oriented, LedgerRecordsWorkOfMovingObstacles) {
  for (const auto how : {OrientedIntegrator::SymplecticEuler, OrientedIntegrator::RungeKutta,
                         OrientedIntegrator::SemiImplicit}) {
    Scene s = patchScene(0);
    s.oriented[0].integrator = how;
    s.oriented[0].damping = s.oriented[0].spinDamping = 4;
    s.oriented[0].stiffness = 10;
    Obstacle& ball = test::addFloor(s);
    ball.shape.kind = ShapeKind::Sphere;
    ball.shape.radius = 0.12;
    ball.shape.move = {0, 0, -0.15};
    ball.motion = {{0, {}, {}}, {0.5, {0, 0, 0.25}, {}}};
    ball.until = 0.25;
    s.end = 0.3;
    test::Simulation x(s);
    ASSERT_TRUE(x.run());
    const LedgerReport l = x.ledgerReport();
    double highest = 0;
    for (std::size_t i = 0; i < x.w.oriented.rows.owned; i++)
      highest = std::max(highest, x.w.oriented.rows.position[i].z);
    EXPECT_GT(highest, 0.05);  // it was pushed
    EXPECT_LT(length(l.momentumResidual), 1e-12);
    EXPECT_LT(std::abs(l.energyResidual), 0.02 * l.energyScale) << static_cast<int>(how);
  }
}

TEST(Oriented, RestsOnAnObstacle) {
  Scene s = patchScene(0);
  s.domain.gravity = {0, 0, -9.81};
  s.oriented[0].shape.move = {0, 0, 0.1};
  s.oriented[0].damping = s.oriented[0].spinDamping = 3;
  test::addFloor(s);
  s.end = 3;
  test::Simulation x(s);
  ASSERT_TRUE(x.run());
  const Oriented& o = x.w.oriented.rows;
  for (std::size_t i = 0; i < o.owned; i++) {
    EXPECT_GT(o.position[i].z, 0);
    EXPECT_LT(o.position[i].z, 0.03);
  }
  EXPECT_LT(std::abs(x.ledgerReport().energyResidual), 0.05 * x.ledgerReport().energyScale);
}

// A patch flies out of an open side, row by row. The ledger records the energy of its pairs with the rest.
TEST(Oriented, LedgerClosesWhenAPatchLeavesTheDomain) {
  Scene s = patchScene(0);
  s.domain.gravity = {};
  const Vec3d size = s.domain.max - s.domain.min;
  s.oriented[0].velocity = {1.5 * size.x, 0, 0};
  s.oriented[0].damping = 1;
  s.end = 0.5;
  test::Simulation x(s);
  const double rows = static_cast<double>(x.w.oriented.rows.owned);
  ASSERT_TRUE(x.run());
  const LedgerReport r = x.ledgerReport();
  std::printf("%lld of %.0f left, residual %.2e of %.2e J\n", static_cast<long long>(x.w.counters.left), rows,
              r.energyResidual, r.energyScale);
  EXPECT_GT(static_cast<double>(x.w.counters.left), 0.2 * rows);
  EXPECT_EQ(x.w.counters.orientedDeaths, 0);
  EXPECT_LT(std::abs(r.massResidual), 1e-15);
  EXPECT_LT(std::abs(r.energyResidual), 0.02 * r.energyScale);
}

}  // namespace
}  // namespace thaw
