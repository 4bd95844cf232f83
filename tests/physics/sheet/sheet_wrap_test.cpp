// SPDX-License-Identifier: Apache-2.0
// Sheets drawn toward bodies from a distance, with the reaction on the body and the energy budget.
#include "tests/support/sheet_samples.hpp"

namespace thaw {
namespace {

/// A sheet of 60 cm, 30 cm above the target. No gravity.
Scene clothOver() {
  Scene s = test::sheetScene(SheetMesh::Grid);
  SheetBody& b = s.sheets[0];
  b.width = b.depth = 0.6;
  b.spacing = 0.05;
  b.shape.move = {0.01, 0.02, 0.3};
  b.shrinkWrap = 20;
  b.shrinkWrapTo = "target";
  s.end = 0.06;
  s.numerics.retryEvery = 0;
  return s;
}

void expectDrawn(const Scene& s, double share) {
  test::Simulation sim(s);
  const Vec3d before = sim.ledgerReport().now.momentum;
  ASSERT_TRUE(sim.run());
  const Sheets& v = sim.w.sheets.rows;
  Vec3d sheet{};
  double area = 0;
  for (std::size_t i = 0; i < v.owned; i++)
    if (v.body[i] == 0) sheet += v.mass[i] * v.velocity[i], area += v.area[i];
  const LedgerReport ledgerReport = sim.ledgerReport();
  EXPECT_LT(sheet.z, -share * 20 * area * s.end);
  EXPECT_LT(length(ledgerReport.momentumResidual), 1e-12 * length(sheet));
  EXPECT_LT(length(ledgerReport.now.momentum + ledgerReport.impulseInFlight - before), 1e-12 * length(sheet))
      << "the body gains what the sheet loses";
  EXPECT_LT(length(ledgerReport.now.angularMomentum - ledgerReport.initial.angularMomentum),
            0.02 * 0.3 * length(sheet));
  EXPECT_GT(ledgerReport.wallWork, 0);
  EXPECT_LT(std::abs(ledgerReport.energyResidual), 0.01 * ledgerReport.energyScale);
}

TEST(SheetWrap, PullsTowardAContinuumBody) {
  Scene s = clothOver();
  s.spacing = 0.03;
  s.materials.emplace_back();
  s.materials[0].name = "rubber";
  s.materials[0].young = {2e4, 2e4};
  test::addBox(s, {-0.15, -0.15, -0.15}, {0.15, 0.15, 0.1}).name = "target";
  expectDrawn(s, 0.5);
}

TEST(SheetWrap, PullsTowardAnOrientedBody) {
  Scene s = clothOver();
  s.oriented.emplace_back();
  OrientedBody& o = s.oriented[0];
  o.name = "target";
  o.source = OrientedSource::Patch;
  o.width = o.depth = 0.4;
  o.spacing = 0.05;
  o.density = 3;
  o.damping = o.spinDamping = 0;
  expectDrawn(s, 0.5);
}

TEST(SheetWrap, PullsTowardAnotherSheet) {
  Scene s = clothOver();
  SheetBody b = s.sheets[0];
  b.name = "target";
  b.shrinkWrap = 0;
  b.shrinkWrapTo.clear();
  b.shape.move = {};
  b.warp = b.weft = b.shear = 50;
  s.sheets.push_back(b);
  expectDrawn(s, 0.5);
}

/// A sheet inside a thick body is drawn out to the nearest side, except within a cell of the middle, where no
/// side is nearest.
TEST(SheetWrap, DrawsOutOfABody) {
  Scene s = clothOver();
  s.spacing = 0.03;
  s.materials.emplace_back();
  s.materials[0].name = "rubber";
  s.materials[0].young = {2e4, 2e4};
  test::addBox(s, {-0.6, -0.6, -0.3}, {0.6, 0.6, 0.3}).name = "target";
  s.sheets[0].width = s.sheets[0].depth = 0.4;
  for (const double z : {0.22, 0.12, -0.12}) {
    s.sheets[0].shape.move = {0.01, 0.02, z};
    test::Simulation sim(s);
    ASSERT_GT(std::abs(z), sim.w.grid.edge.x);
    const Sheets& v = sim.w.sheets.rows;
    for (std::size_t i = 0; i < v.owned; i++) EXPECT_GT(v.outside[i].z * (z > 0 ? 1 : -1), 0.8 * 20) << z;
  }
}

/// A closed membrane comes to rest around a ball and compresses it without moving it.
TEST(SheetWrap, MembraneComesToRestAroundABall) {
  Scene s = test::sheetScene(SheetMesh::Sphere);
  s.spacing = 0.04;
  s.materials.emplace_back();
  s.materials[0].name = "rubber";
  s.materials[0].young = {1e5, 1e5};
  s.bodies.emplace_back();
  s.bodies[0].name = "ball";
  s.bodies[0].shape.kind = ShapeKind::Sphere;
  s.bodies[0].shape.radius = 0.2;
  SheetBody& b = s.sheets[0];
  b.radius = 0.4;
  b.spacing = 0.05;
  b.damping = 40;
  b.warp = b.weft = b.shear = 30;
  b.restLength = 0.5;  // relative to the ball
  b.shrinkWrap = 20;
  b.shrinkWrapTo = "ball";
  s.end = 1;
  test::Simulation sim(s);
  ASSERT_TRUE(sim.run());
  const Sheets& v = sim.w.sheets.rows;
  for (std::size_t i = 0; i < v.owned; i++) {
    EXPECT_GT(length(v.position[i]), 0.17);
    EXPECT_LT(length(v.position[i]), 0.27);
  }
}

}  // namespace
}  // namespace thaw
