// SPDX-License-Identifier: Apache-2.0
// Coefficients of sheets that vary in time and by region: forces, energy budget, steps.
#include "tests/support/sheet_samples.hpp"

namespace thaw {
namespace {

using F = SheetFactor;
using test::expectForcesFromEnergy, test::sheetScene;

/// The half of a sheet beyond x = 0.
SheetRegion& addHalf(SheetBody& b) {
  b.regions.emplace_back();
  b.regions.back().shape = test::boxOf({0.01, -2, -2}, {2, 2, 2});
  return b.regions.back();
}

Scene clothOfAll() {
  Scene s = sheetScene(SheetMesh::Grid);
  SheetBody& b = s.sheets[0];
  b.warp = 30, b.weft = 12, b.shear = 4, b.bending = 2;
  b.repulsion = 2, b.attraction = 1, b.attractionRange = 0.1, b.thickness = 0.25;
  b.stretchLimit = 1.02;
  return s;
}

Scene ball() {
  Scene s = sheetScene(SheetMesh::Sphere);
  s.sheets[0].volumeStiffness = 500;
  s.sheets[0].warp = s.sheets[0].weft = s.sheets[0].shear = 10;
  return s;
}

TEST(SheetCoefficients, ForcesAreGradientsOfEnergiesAtAnyTimeAndInRegions) {
  for (Scene s : {clothOfAll(), ball()}) {
    SheetBody& b = s.sheets[0];
    SheetRegion& half = addHalf(b);
    double k = 1;
    for (const F f :
         {F::Warp, F::Weft, F::Shear, F::Bending, F::Volume, F::Repulsion, F::Attraction, F::Stiffness}) {
      half.factor[placeOf(f)] = k += 0.5;
      b.inTime[placeOf(f)].points = {{0, 1}, {1, 1 + k}};
    }
    expectForcesFromEnergy(s, 0.7);
  }
}

/// Stretches a strip of two materials and changes one coefficient after another. The ledger records the
/// energy of the change, and the residual falls with the square of the step.
TEST(SheetCoefficients, LedgerRecordsWorkOfChanges) {
  for (const F f : {F::Warp, F::Shear, F::Bending, F::Volume, F::Repulsion, F::Attraction, F::Stiffness}) {
    double residual[2], scale = 0;
    for (int k = 0; k < 2; k++) {
      Scene s = f == F::Volume ? ball() : clothOfAll();
      SheetBody& b = s.sheets[0];
      b.stiffness = 3;
      b.restLength = 0.97;  // the whole strip is stretched
      b.stretchLimit = never;
      if (f == F::Volume) b.shrinkWrap = 40;
      addHalf(b).factor[placeOf(f)] = 2;
      b.inTime[placeOf(f)].points = {{0.05, 1}, {0.2, 3}, {0.3, 0.2}};
      if (f == F::Repulsion || f == F::Attraction) {  // these act between two sheets
        b.restLength = 1;
        b.contactRate = 1, b.friction = 0, b.restitution = 1;
        s.sheets.push_back(b);
        s.sheets[1].name = "other";
        s.sheets[1].shape.move = {0.03, 0.02, f == F::Repulsion ? 0.2 : 0.3};
      }
      s.end = 0.4;
      s.numerics.fixedStep = k == 0 ? 4e-4 : 2e-4;
      s.numerics.retryEvery = 0;
      test::Simulation sim(s);
      ASSERT_TRUE(sim.run());
      const LedgerReport ledgerReport = sim.ledgerReport();
      residual[k] = std::abs(ledgerReport.energyResidual), scale = ledgerReport.energyScale;
      EXPECT_GT(std::abs(ledgerReport.wallWork), 100 * residual[k]) << placeOf(f);
    }
    EXPECT_LT(residual[1], 1e-3 * scale) << placeOf(f);
    EXPECT_LT(residual[1], 0.35 * residual[0] + 1e-6 * scale) << placeOf(f);
  }
}

/// Springs that appear in time: the step shortens before they are stiff.
TEST(SheetCoefficients, StepsShortenBeforeSpringsGrowStiff) {
  Scene s = sheetScene(SheetMesh::Grid);
  SheetBody& b = s.sheets[0];
  b.warp = b.weft = b.shear = 4000;
  b.restLength = 0.98;
  for (const F f : {F::Warp, F::Weft, F::Shear}) b.inTime[placeOf(f)].points = {{0.5, 0}, {0.502, 1}};
  s.output.every = 0.1;
  s.end = 0.6;
  s.numerics.retryEvery = 0;
  test::Simulation sim(s);
  double most = 0;
  while (sim.w.clock.time < s.end) {
    ASSERT_TRUE(sim.step());
    const LedgerReport ledgerReport = sim.ledgerReport();
    most = std::max(most, std::abs(ledgerReport.energyResidual) / std::max(ledgerReport.energyScale, 1e-9));
  }
  EXPECT_LT(most, 0.02);
  EXPECT_LT(sim.shortest, 0.002);
}

/// Chosen steps resolve fast changes. One step from frame to frame over a change would give errors of 27 %
/// (damping) to 160 % (stiffness) in positions.
TEST(SheetCoefficients, FastChangesAreResolved) {
  for (const double ramp : {0.1, 0.01, 0.001})
    for (const F f : {F::Stiffness, F::Damping}) {
      std::vector<Vec3d> at[2];
      double size = 0, off = 0;
      for (const double dt : {0.0, 1e-4}) {
        Scene s = sheetScene(SheetMesh::Grid);
        SheetBody& b = s.sheets[0];
        b.stiffness = 300;
        if (f == F::Damping) b.damping = 5;
        b.velocity = {0, 0, 1};
        b.inTime[placeOf(f)].points = {{0.05, 1}, {0.05 + ramp, 3}, {0.05 + 2 * ramp, 0.2}};
        s.end = 0.4;
        s.output.every = 0.1;
        s.numerics.fixedStep = dt;
        s.numerics.retryEvery = 0;
        test::Simulation sim(s);
        ASSERT_TRUE(sim.run());
        if (dt == 0) { EXPECT_LT(sim.w.clock.step, 200); }
        const Sheets& v = sim.w.sheets.rows;
        for (std::size_t i = 0; i < v.owned; i++) at[dt > 0].push_back(v.position[i] - v.rest[i]);
      }
      for (std::size_t i = 0; i < at[0].size(); i++)
        size = std::max(size, length(at[1][i])), off = std::max(off, length(at[0][i] - at[1][i]));
      EXPECT_LT(off, 0.005 * size) << ramp << " " << placeOf(f);
    }
}

TEST(SheetCoefficients, WindAndWrapFollowTheirRegionAndTime) {
  Scene s = sheetScene(SheetMesh::Grid);
  SheetBody& b = s.sheets[0];
  b.shrinkWrap = 2;
  b.windDensity = 1.2;
  b.wind = {0, 0, 1};
  SheetRegion& half = addHalf(b);
  half.factor[placeOf(F::ShrinkWrap)] = -0.5;
  half.factor[placeOf(F::Wind)] = 3;
  b.inTime[placeOf(F::ShrinkWrap)].points = {{0, 1}, {1, 3}};
  b.inTime[placeOf(F::Wind)].points = {{0, 0}, {1, 1}};
  test::Simulation sim(s);
  sim.w.clock.time = 0.5;
  test::energyOf(sim);
  const Sheets& v = sim.w.sheets.rows;
  for (std::size_t i = 0; i < v.owned; i++) {
    const bool there = v.position[i].x > 0.01;
    EXPECT_NEAR(v.load[i].z, there ? -2 * 2 * -0.5 + 1.2 * 3 * 0.5 : -2 * 2 + 1.2 * 0.5, 1e-12);
  }
}

}  // namespace
}  // namespace thaw
