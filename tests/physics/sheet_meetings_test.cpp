// Sheets that meet the continuum: contact, heat, books.
#include <gtest/gtest.h>

#include <cmath>

#include "core/sheet/nearest_points.hpp"
#include "tests/support/sheet_samples.hpp"

namespace thaw {
namespace {

using test::sheetScene;

TEST(Sheets, MeetTheContinuumAndTakeItsHeat) {
  Scene s;
  s.spacing = 0.05;
  s.domain.min = {-0.6, -0.6, -0.2};
  s.domain.max = {0.6, 0.6, 0.8};
  s.output.every = 0;
  s.materials.emplace_back();
  Material& m = s.materials[0];
  m.name = "rubber";
  m.young = {1e5, 1e5};
  m.damping = 5;
  m.conductivity = {100, 100};
  test::addBox(s, {-0.2, -0.2, 0.1}, {0.2, 0.2, 0.3}).temperature = 400;
  s.sheets.emplace_back();
  SheetBody& b = s.sheets[0];
  b.name = "cloth";
  b.width = b.depth = 0.5;
  b.spacing = 0.04;
  b.shape.move = {0, 0, 0.38};
  b.warp = b.weft = 50, b.shear = 10;
  b.conductance = 500;
  b.temperature = 300;
  s.domain.gravity = {0, 0, -9.81};
  test::addFloor(s);
  s.end = 0.3;
  test::Simulation sim(s);
  ASSERT_TRUE(sim.run());
  const Sheets& v = sim.w.sheets.rows;
  double hottest = 0, lowest = 1;
  for (std::size_t i = 0; i < v.owned; i++) {
    hottest = std::max(hottest, v.temperature[i]);
    if (std::abs(v.position[i].x) < 0.1 && std::abs(v.position[i].y) < 0.1) lowest = std::min(lowest, v.position[i].z);
  }
  EXPECT_GT(hottest, 303);
  EXPECT_LT(hottest, 400);
  EXPECT_GT(lowest, 0.15);  // it lies on the box
  const LedgerReport books = sim.books();
  EXPECT_LT(length(books.momentumResidual), 1e-9);
  EXPECT_LT(std::abs(books.energyResidual), 0.05 * books.energyScale);
  EXPECT_LT(std::abs(books.heatResidual), 1e-9 * std::abs(books.now.internal));
}

/// Water on a cloth whose vertices are three of its spacings apart, held at its border: none passes through, and the books close.
TEST(Sheets, CoarseClothHoldsFinerParticles) {
  Scene s;
  s.spacing = 0.02;
  s.domain.min = {-0.5, -0.5, -1};
  s.domain.max = {0.5, 0.5, 0.5};
  s.domain.gravity = {0, 0, -9.81};
  s.output.every = 0;
  s.materials.emplace_back();
  Material& m = s.materials[0];
  m.name = "water";
  m.soundSpeed = 20;
  m.viscosity = {0.5, 0.5};
  m.conductivity = {10, 10};
  test::addBox(s, {-0.1, -0.1, 0.05}, {0.1, 0.1, 0.17}).temperature = 350;
  s.sheets.emplace_back();
  SheetBody& b = s.sheets[0];
  b.name = "cloth";
  b.width = b.depth = 0.9;
  b.spacing = 0.06;
  b.mass = 1;
  b.damping = 2;
  b.warp = b.weft = 2000, b.shear = 300;
  b.conductance = 300;
  b.temperature = 300;
  Shape hole = test::boxOf({-0.4, -0.4, -1}, {0.4, 0.4, 1}), all = test::boxOf({-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}), rim;
  rim.kind = ShapeKind::Difference;
  rim.parts = {all, hole};
  b.clamp.push_back(rim);
  s.end = 0.4;
  test::Simulation sim(s);
  ASSERT_TRUE(sim.w.sheets.plans[0].byFaces);
  ASSERT_TRUE(sim.run());
  const Continuum& p = sim.w.particles;
  const Sheets& v = sim.w.sheets.rows;
  double lowest = 1, hottest = 0;
  std::vector<Vec3d> at(v.owned);
  for (std::size_t i = 0; i < v.owned; i++) {
    at[v.id[i]] = v.position[i];
    lowest = std::min(lowest, v.position[i].z);
    hottest = std::max(hottest, v.temperature[i]);
  }
  EXPECT_EQ(p.owned, 600u);
  EXPECT_LT(lowest, -0.01);  // it bears the water
  for (std::size_t i = 0; i < p.owned; i++) {  // above the triangle that it is over
    double under = -1;
    for (const auto& t : sim.w.sheets.plans[0].mesh.triangles) {
      Vec3d a = at[t[0]], c = at[t[1]], d = at[t[2]], x = p.position[i];
      const double heights[3] = {a.z, c.z, d.z};
      a.z = c.z = d.z = x.z = 0;
      const Vec3d share = sharesOfNearest(a, c, d, x), off = share.x * a + share.y * c + share.z * d - x;
      if (length(off) < 1e-9) under = share.x * heights[0] + share.y * heights[1] + share.z * heights[2];
    }
    ASSERT_GT(p.position[i].z, under) << i;
    ASSERT_GT(under, -1) << i << " at " << p.position[i].x << " " << p.position[i].y << " " << p.position[i].z;
  }
  EXPECT_GT(hottest, 301);
  const LedgerReport books = sim.books();
  EXPECT_LT(length(books.momentumResidual), 1e-9);
  EXPECT_LT(std::abs(books.energyResidual), 0.02 * books.energyScale);
  EXPECT_LT(std::abs(books.heatResidual), 1e-9 * std::abs(books.now.internal));
}

}  // namespace
}  // namespace thaw
