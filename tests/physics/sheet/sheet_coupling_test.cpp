// SPDX-License-Identifier: Apache-2.0
// Coupling of sheets with the continuum: contact, heat, energy budget.
#include <gtest/gtest.h>

#include <cmath>

#include "core/sheet/search/nearest_points.hpp"
#include "tests/support/sheet_samples.hpp"

namespace thaw {
namespace {

using test::sheetScene;

TEST(Sheets, TouchTheContinuumAndTakeItsHeat) {
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
    if (std::abs(v.position[i].x) < 0.1 && std::abs(v.position[i].y) < 0.1)
      lowest = std::min(lowest, v.position[i].z);
  }
  EXPECT_GT(hottest, 303);
  EXPECT_LT(hottest, 400);
  EXPECT_GT(lowest, 0.15);  // it lies on the box
  const LedgerReport ledgerReport = sim.ledgerReport();
  EXPECT_LT(length(ledgerReport.momentumResidual), 1e-9);
  EXPECT_LT(std::abs(ledgerReport.energyResidual), 0.05 * ledgerReport.energyScale);
  EXPECT_LT(std::abs(ledgerReport.heatResidual), 1e-9 * std::abs(ledgerReport.now.internal));
}

/// A block lies in a sagging net whose vertices are not above its particles.
Scene blockInANet(double turned) {
  Scene s = test::emptyScene(0.05, {-1, -1, -1}, {1, 1, 1});
  s.materials.emplace_back();
  s.materials[0].name = "rubber";
  s.materials[0].young = {1e5, 1e5};
  test::addBox(s, {-0.1, -0.1, 0.03}, {0.1, 0.1, 0.23});
  s.sheets.emplace_back();
  SheetBody& b = s.sheets[0];
  b.name = "net";
  b.width = b.depth = 0.5;
  b.spacing = 0.04;
  b.mass = 2;
  b.shape.rotate = {0, 0, turned};
  return s;
}

/// Contact by triangles derives from one energy: its gradient is the force on every corner and particle, also
/// within reach of several triangles.
TEST(Sheets, FaceContactIsTheGradientOfAnEnergy) {
  test::Simulation sim(blockInANet(0.3));
  ASSERT_TRUE(sim.w.sheets.plans[0].byFaces);
  Sheets& v = sim.w.sheets.rows;
  Continuum& p = sim.w.particles;
  for (std::size_t i = 0; i < v.owned; i++) {
    const Vec3d x = v.position[i];
    v.position[i].z += 0.02 + 0.3 * (dot(x, x) - 0.01) + 0.01 * std::sin(40 * x.x) * std::cos(31 * x.y);
  }
  const auto energy = [&] {
    std::fill_n(p.force.data(), p.owned, Vec3d{});
    return 2 * test::energyOf(sim);  // the other half belongs to the particles
  };
  energy();
  std::vector<Vec3d> onParticles(p.force.data(), p.force.data() + p.owned), onVertices(v.owned);
  double largest = 0;
  std::size_t touched = 0;
  for (std::size_t i = 0; i < v.owned; i++) {
    onVertices[i] = v.load[i] * v.area[i];
    largest = std::max(largest, length(onVertices[i]));
    touched += length(onVertices[i]) > 0;
  }
  ASSERT_GT(touched, 20u);
  const auto slope = [&](double& x) {
    const double at = x, h = 1e-7;
    x = at + h;
    const double up = energy();
    x = at - h;
    const double down = energy();
    x = at;
    return (up - down) / (2 * h);
  };
  for (std::size_t i = 0; i < v.owned; i++)
    for (int a = 0; a < 3 && length(onVertices[i]) > 0; a++)
      EXPECT_NEAR(onVertices[i][a], -slope(v.position[i][a]), 1e-5 * largest) << i << " " << a;
  for (std::size_t j = 0; j < p.owned; j++)
    for (int a = 0; a < 3 && length(onParticles[j]) > 0; a++)
      EXPECT_NEAR(onParticles[j][a], -slope(p.position[j][a]), 1e-5 * largest) << j << " " << a;
}

/// A rubber cube falls on a net, which gives way, so that the nearest triangle changes all the time. The
/// depth of the nearest triangle alone would leave up to 93 % of the energy unexplained.
TEST(Sheets, LedgerClosesForACubeOnANet) {
  for (const double turned : {0.0, 0.44}) {
    Scene s = blockInANet(turned);
    s.domain.gravity = {0, 0, -9.81};
    s.bodies[0].velocity = {0, 0, -1.7};
    s.materials[0].young = {2e5, 2e5};
    s.bodies[0].shape.move.z += 0.05;
    SheetBody& b = s.sheets[0];
    b.mass = 0.5;
    b.warp = b.weft = 3000, b.shear = 500;
    b.width = b.depth = 0.8;
    Shape rim;  // everything beyond the middle
    rim.kind = ShapeKind::Difference;
    rim.parts = {test::boxOf({-1, -1, -1}, {1, 1, 1}), test::boxOf({-0.35, -0.35, -2}, {0.35, 0.35, 2})};
    b.clamp.push_back(rim);
    s.end = 0.25;
    test::Simulation sim(s);
    const double most = test::worstResidual(sim, s.end);
    EXPECT_LT(most, 0.01) << turned;
  }
}

/// A block slides over a free coarse cloth. Friction at nearest points with a gap conserves angular momentum.
TEST(Sheets, FrictionWithTrianglesKeepsAngularMomentum) {
  Vec3d way[3];
  for (const int rough : {0, 1, 2}) {  // smooth, both rough, only the block rough
    Scene s = test::emptyScene(0.05, {-1, -1, -1}, {1, 1, 1});
    s.materials.emplace_back();
    s.materials[0].name = "rubber";
    s.materials[0].young = {1e5, 1e5};
    s.materials[0].friction = rough ? 0.8 : 0;
    Body& block = test::addBox(s, {-0.1, -0.1, 0.06}, {0.1, 0.1, 0.26});
    block.velocity = {0.6, 0.2, -0.5};
    s.sheets.emplace_back();
    SheetBody& b = s.sheets[0];
    b.name = "cloth";
    b.width = b.depth = 0.8;
    b.spacing = 0.1;
    b.mass = 2;
    b.warp = b.weft = 50, b.shear = 10;
    b.friction = rough == 1 ? 0.8 : 0;
    s.end = 0.2;
    test::Simulation sim(s);
    ASSERT_TRUE(sim.w.sheets.plans[0].byFaces);
    const LedgerReport before = sim.ledgerReport();
    ASSERT_TRUE(sim.run());
    const LedgerReport ledgerReport = sim.ledgerReport();
    const double scale = length(before.now.angularMomentum) + before.now.mass * 0.1;
    EXPECT_LT(length(ledgerReport.now.momentum - before.now.momentum), 1e-11 * scale) << rough;
    EXPECT_LT(length(ledgerReport.now.angularMomentum - before.now.angularMomentum), 1e-11 * scale) << rough;
    EXPECT_LT(std::abs(ledgerReport.energyResidual), 0.02 * ledgerReport.energyScale) << rough;
    const Sheets& v = sim.w.sheets.rows;
    for (std::size_t i = 0; i < v.owned; i++) way[rough] += (v.area[i] / 0.64) * v.velocity[i];
  }
  EXPECT_GT(way[1].x, way[0].x + 0.02);  // the block drags the cloth
  EXPECT_GT(way[2].x, way[0].x + 0.02);  // the larger friction counts
}

/// A hot block touches the middle of a coarse cloth. Vertices at the rim of contact stay cold. Nothing gets
/// hotter than the block or cools it below the cloth. Heat must not be distributed by the weights of the
/// nearest point. This would heat vertices to 455 K next to a block of 400 K.
TEST(Sheets, NothingGetsHotterThanItsHeatSource) {
  for (const double spacing : {0.015, 0.03, 0.01}) {  // the last one by points
    Scene s = test::emptyScene(0.02, {-0.5, -0.5, -0.1}, {0.5, 0.5, 0.6});
    s.materials.emplace_back();
    Material& m = s.materials[0];
    m.name = "rubber";
    m.density = 500;
    m.young = {1e5, 1e5};
    m.conductivity = {20, 20};
    m.heatCapacity = {500, 500};
    Body& block = test::addBox(s, {-0.08, -0.08, 0}, {0.08, 0.08, 0.04});
    block.temperature = 400;
    block.clamp.push_back(test::boxOf({-1, -1, -1}, {1, 1, 1}));
    s.sheets.emplace_back();
    SheetBody& b = s.sheets[0];
    b.name = "cloth";
    b.width = b.depth = 0.24;
    b.spacing = spacing;
    b.shape.move = {0.003, 0.005, 0.042};
    b.mass = 0.3;
    b.warp = b.weft = 100;
    b.clamp.push_back(test::boxOf({-1, -1, -1}, {1, 1, 1}));
    b.temperature = 300;
    b.heatCapacity = 300;
    b.conductance = 1000;
    s.numerics.maxStep = 2e-3;
    s.end = 2;
    test::Simulation sim(s);
    ASSERT_EQ(sim.w.sheets.plans[0].byFaces, spacing > 0.012);
    ASSERT_TRUE(sim.run());
    const Sheets& v = sim.w.sheets.rows;
    const Continuum& p = sim.w.particles;
    double hottest = 0, coldest = 1e9;
    std::size_t warm = 0;
    for (std::size_t i = 0; i < v.owned; i++) {
      hottest = std::max(hottest, v.temperature[i]);
      warm += v.temperature[i] > 370;
    }
    for (std::size_t i = 0; i < p.owned; i++)
      coldest = std::min(coldest, static_cast<double>(p.temperature[i]));
    EXPECT_LE(hottest, 400) << spacing;
    EXPECT_GE(coldest, 300) << spacing;
    EXPECT_GT(warm, 20u) << spacing;
    EXPECT_LT(std::abs(sim.ledgerReport().heatResidual), 1e-9 * std::abs(sim.ledgerReport().now.internal));
  }
}

/// Liquid particles below a sheet, each by the triangle above it, and all those below no triangle.
std::size_t underSheet(const World& w) {
  const Sheets& v = w.sheets.rows;
  std::vector<Vec3d> at(v.owned);
  for (std::size_t i = 0; i < v.owned; i++) at[v.id[i]] = v.position[i];
  std::size_t n = 0;
  for (std::size_t i = 0; i < w.particles.owned; i++) {
    double under = never;
    for (const auto& t : w.sheets.plans[0].mesh.triangles) {
      Vec3d a = at[t[0]], c = at[t[1]], d = at[t[2]], x = w.particles.position[i];
      const double heights[3] = {a.z, c.z, d.z};
      a.z = c.z = d.z = x.z = 0;
      const Vec3d share = sharesOfNearest(a, c, d, x), off = share.x * a + share.y * c + share.z * d - x;
      if (length(off) < 1e-9) under = share.x * heights[0] + share.y * heights[1] + share.z * heights[2];
    }
    n += !(w.particles.position[i].z > under);
  }
  return n;
}

/// A box of water over a cloth that is fixed at its border.
Scene waterOnACloth(double spacing, const Vec3d& low, const Vec3d& high) {
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
  test::addBox(s, low, high).temperature = 350;
  s.sheets.emplace_back();
  SheetBody& b = s.sheets[0];
  b.name = "cloth";
  b.width = b.depth = 0.9;
  b.spacing = spacing;
  b.mass = 1;
  b.damping = 2;
  b.warp = b.weft = 2000, b.shear = 300;
  b.conductance = 300;
  b.temperature = 300;
  Shape hole = test::boxOf({-0.4, -0.4, -1}, {0.4, 0.4, 1}),
        all = test::boxOf({-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}), rim;
  rim.kind = ShapeKind::Difference;
  rim.parts = {all, hole};
  b.clamp.push_back(rim);
  s.end = 0.4;
  return s;
}

/// Water on a cloth with vertices three, one or half of its spacings apart. None passes through at the
/// automatic contact rate, and the ledger closes. Contact stiffness must not follow the mass of the vertices,
/// since light cloths would leak.
TEST(Sheets, ClothHoldsWaterForAnyVertexSpacing) {
  for (const double spacing : {0.06, 0.02, 0.01}) {
    Scene s = waterOnACloth(spacing, {-0.1, -0.1, 0.05}, {0.1, 0.1, 0.17});
    if (spacing < 0.06) {
      s.sheets[0].mass = 0.3;
      s.sheets[0].width = s.sheets[0].depth = 0.6;
      s.sheets[0].clamp[0].parts[1] = test::boxOf({-0.25, -0.25, -1}, {0.25, 0.25, 1});
      s.bodies[0].shape = test::boxOf({-0.08, -0.08, 0.03}, {0.08, 0.08, 0.19});
      s.end = 0.3;  // before water splashes over the border
    }
    test::Simulation sim(s);
    ASSERT_EQ(sim.w.sheets.plans[0].byFaces, spacing > 0.015);
    const std::size_t all = sim.w.particles.owned;
    ASSERT_TRUE(sim.run());
    const Sheets& v = sim.w.sheets.rows;
    double lowest = 1, hottest = 0;
    for (std::size_t i = 0; i < v.owned; i++)
      lowest = std::min(lowest, v.position[i].z), hottest = std::max(hottest, v.temperature[i]);
    EXPECT_EQ(sim.w.particles.owned, all) << spacing;
    EXPECT_LT(lowest, -0.003) << spacing;  // the water loads it
    EXPECT_EQ(underSheet(sim.w), 0u) << spacing;
    EXPECT_GT(hottest, 301) << spacing;
    const LedgerReport ledgerReport = sim.ledgerReport();
    EXPECT_LT(length(ledgerReport.momentumResidual), 1e-9);
    EXPECT_LT(std::abs(ledgerReport.energyResidual), 0.003 * ledgerReport.energyScale) << spacing;
    EXPECT_LT(std::abs(ledgerReport.heatResidual), 1e-9 * std::abs(ledgerReport.now.internal));
    EXPECT_EQ(ledgerReport.liquidFraction, 1);  // continuum only: a cloth is neither liquid nor solid there
  }
}

}  // namespace
}  // namespace thaw
