// SPDX-License-Identifier: Apache-2.0
// Oriented bodies: momentum, energy, integrators, rest, operations, and the remedies of stability rows 17 and
// 33.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/oriented/adaptive_sampling/events.hpp"
#include "core/oriented/forces/oriented_forces.hpp"
#include "core/oriented/step_oriented.hpp"
#include "tests/support/oriented_samples.hpp"

namespace thaw {
namespace {

using test::patchScene;

double pairEnergy(test::Simulation& x) { return x.ledgerReport().now.elastic; }

TEST(Oriented, EnergyAndMomentaAreConserved) {
  for (const auto how : {OrientedIntegrator::SymplecticEuler, OrientedIntegrator::RungeKutta}) {
    Scene s = patchScene(0.1);
    s.oriented[0].integrator = how;
    s.oriented[0].cfl = 0.05;
    test::Simulation x(s);
    const LedgerReport before = x.ledgerReport();
    for (int k = 0; k < 400; k++) ASSERT_TRUE(x.step());
    const LedgerReport after = x.ledgerReport();
    const double scale = after.now.kinetic;
    EXPECT_GT(scale, 0);
    EXPECT_LT(std::abs(after.energyResidual), (how == OrientedIntegrator::RungeKutta ? 2e-5 : 0.05) * scale);
    EXPECT_LT(length(after.now.momentum - before.now.momentum), 1e-12);
    EXPECT_LT(length(after.now.angularMomentum - before.now.angularMomentum),
              how == OrientedIntegrator::RungeKutta ? 1e-8 : 1e-12);
  }
}

TEST(Oriented, RungeKuttaIsOfFourthOrder) {
  double error[3];
  Vec3d fine{};
  std::vector<Vec3d> last[4];
  const double steps[4] = {2e-3, 1e-3, 5e-4, 1.25e-4};
  for (int k = 0; k < 4; k++) {
    Scene s = patchScene(0.05);
    s.oriented[0].integrator = OrientedIntegrator::RungeKutta;
    s.oriented[0].stiffness = 1;
    s.numerics.fixedStep = steps[k];
    s.end = 0.02;
    test::Simulation x(s);
    ASSERT_TRUE(x.run());
    const Oriented& o = x.w.oriented.rows;
    std::vector<Vec3d> byId(o.owned);
    for (std::size_t i = 0; i < o.owned; i++) byId[o.id[i]] = o.position[i];
    last[k] = byId;
  }
  (void)fine;
  for (int k = 0; k < 3; k++) {
    error[k] = 0;
    for (std::size_t i = 0; i < last[3].size(); i++)
      error[k] = std::max(error[k], length(last[k][i] - last[3][i]));
  }
  EXPECT_GT(std::log2(error[0] / error[1]), 3.5);
  EXPECT_GT(std::log2(error[1] / error[2]), 3.5);
}

TEST(Oriented, SemiImplicitIsStableFarBeyondTheExplicitStep) {
  Scene s = patchScene(0.1);
  s.oriented[0].damping = 1;
  test::Simulation plain(s);
  const double limit = plain.w.clock.dt / s.oriented[0].cfl;
  s.oriented[0].integrator = OrientedIntegrator::SemiImplicit;
  s.numerics.fixedStep = 5 * limit;
  s.end = 1000 * limit;
  test::Simulation x(s);
  const double before = pairEnergy(x);
  ASSERT_TRUE(x.run());
  EXPECT_LT(pairEnergy(x), before);
  EXPECT_LT(x.ledgerReport().now.kinetic, 1e-3 * std::abs(before));
}

// The integrator of the first body applies to all, and so does its step limit.
TEST(Oriented, FirstIntegratorSetsTheStep) {
  double dt[2];
  for (const bool both : {false, true}) {
    Scene s = patchScene(0.1);
    s.oriented.push_back(s.oriented[0]);
    s.oriented[1].shape.move = {0, 0, 0.5};
    s.oriented[0].integrator = OrientedIntegrator::SemiImplicit;
    if (both) s.oriented[1].integrator = OrientedIntegrator::SemiImplicit;
    const test::Simulation sim(s);
    dt[both] = orientedStepLimit(sim.w.oriented.rows, sim.w.scene, {});
  }
  EXPECT_EQ(dt[0], dt[1]);
}

TEST(Oriented, PatchRelaxesToAPlane) {
  Scene s = patchScene(0.1);
  s.oriented[0].relax = 20000;
  test::Simulation x(s);
  const Oriented& o = x.w.oriented.rows;
  PairPotential p = x.tools.oriented.potentials[0];
  p.attract = 0;
  double energy = 0;
  for (std::size_t i = 0; i < o.owned; i++)
    for (std::uint32_t k = x.tools.oriented.lists.first[i]; k < x.tools.oriented.lists.first[i + 1]; k++) {
      const std::uint32_t j = x.tools.oriented.lists.list[k];
      energy += pairForces(p, o.position[j] - o.position[i], o.normal[i], o.normal[j]).energy;
    }
  EXPECT_LT(energy / (p.scale * static_cast<double>(o.owned)), 1e-10);
}

TEST(Oriented, AntiparallelPairTurns) {  // stability row 17
  Scene s = patchScene(0);
  OrientedBody& b = s.oriented[0];
  b.source = OrientedSource::Points;
  b.points = {{0, 0, 0}, {0.05, 0, 0}};
  b.normals = {{0, 0, 1}, {0, 0, -1}};
  b.facing = false;
  b.damping = b.spinDamping = 20;
  s.end = 2;
  test::Simulation x(s);
  ASSERT_TRUE(x.run());
  EXPECT_GT(dot(x.w.oriented.rows.normal[0], x.w.oriented.rows.normal[1]), 0.9);
}

TEST(Oriented, CutRemovesForcesAndWeldAddsThem) {
  Scene s = patchScene(0);
  OrientedEvent cut;
  cut.kind = OrientedEventKind::Cut;
  cut.normal = {1, 0, 0};
  s.oriented[0].events.push_back(cut);
  test::Simulation x(s);
  const Oriented& o = x.w.oriented.rows;
  std::size_t left = 0;
  for (std::size_t i = 0; i < o.owned; i++) {
    left += o.cutSides[i] == 2;
    for (std::size_t j = 0; j < o.owned; j++)
      EXPECT_EQ(sameSurface(o, i, j), (o.position[i].x > 0) == (o.position[j].x > 0));
  }
  EXPECT_GT(left, 30u);
  OrientedEvent stroke;
  stroke.tool = CutTool::Line;
  stroke.path = {{-0.1, 0, 1}, {0.1, 0, 1}};
  EXPECT_NE(sideOfCut(stroke, nullptr, 0.15, {0, 0.02, 0}), sideOfCut(stroke, nullptr, 0.15, {0, -0.02, 0}));
  EXPECT_EQ(sideOfCut(stroke, nullptr, 0.15, {0.12, 0.02, 0}), 0);
  EXPECT_EQ(sideOfCut(stroke, nullptr, 0.15, {0, 0.2, 0}), 0);
}

/// Welded rims that overlap by half a spacing. Particles that are too close are removed, and the surface is
/// connected and at rest.
TEST(Oriented, WeldOfOverlappingRimsHolds) {
  Scene s = patchScene(0);
  s.oriented[0].damping = s.oriented[0].spinDamping = 12;
  s.oriented[0].density = 20;
  s.oriented.push_back(s.oriented[0]);
  s.oriented[1].name = "other";
  s.oriented[1].shape.move = {0.6, 0, 0};
  test::Simulation apart(s);
  const Oriented& at = apart.w.oriented.rows;
  double nearest = 1, closer = 0;  // until some are half a spacing apart
  while (nearest > 0.5 * s.spacing) {
    closer += 0.001;
    for (std::size_t i = 0; i < at.owned; i++)
      for (std::size_t j = 0; j < at.owned; j++)
        if (at.body[i] == 0 && at.body[j] == 1)
          nearest = std::min(nearest, length(at.position[j] - Vec3d{closer, 0, 0} - at.position[i]));
  }
  s.oriented[1].shape.move.x -= closer;
  OrientedEvent weld;
  weld.kind = OrientedEventKind::Weld;
  weld.time = 0.1;
  weld.otherIndex = 1;
  s.oriented[0].events.push_back(weld);
  test::Simulation x(s);
  const std::size_t before = x.w.oriented.rows.owned;
  ASSERT_TRUE(x.run());
  const Oriented& o = x.w.oriented.rows;
  EXPECT_EQ(static_cast<std::int64_t>(before - o.owned), x.w.counters.orientedDeaths);
  EXPECT_GT(x.w.counters.orientedDeaths, 0);
  EXPECT_LT(x.w.counters.orientedDeaths, 25);  // less than one row
  for (std::size_t i = 0; i < o.owned; i++) {
    int beside = 0;
    for (std::size_t j = 0; j < o.owned; j++)
      beside += i != j && length(o.position[i] - o.position[j]) < 1.5 * s.spacing;
    EXPECT_GE(beside, 2) << i;
    EXPECT_LT(std::abs(o.position[i].z), 0.5 * s.spacing);
  }
  const LedgerReport ledgerReport = x.ledgerReport();
  EXPECT_LT(std::abs(ledgerReport.energyResidual), 0.01 * ledgerReport.energyScale);
  EXPECT_LT(std::abs(ledgerReport.massResidual), 1e-12);
}

TEST(Oriented, MassIsDensityTimesArea) {
  Scene s = patchScene(0);
  s.oriented[0].density = 3;
  s.oriented[0].shape.scale = 1.3;
  EXPECT_NEAR(test::Simulation(s).ledgerReport().now.mass, 3 * 0.65 * 0.65, 1e-12);
  s.oriented[0].source = OrientedSource::Disc;
  s.oriented[0].radius = 0.4;
  EXPECT_NEAR(test::Simulation(s).ledgerReport().now.mass, 3 * std::numbers::pi * 0.52 * 0.52, 1e-12);
}

TEST(Oriented, CurveFollowsALiftedPoint) {  // as in scenes/oriented/curve2d.toml
  Scene s = patchScene(0);
  OrientedBody& b = s.oriented[0];
  b.source = OrientedSource::Curve;
  b.planar = true;
  b.from = {-0.6, 0, 0};
  b.to = {0.6, 0, 0};
  b.bulge = 0.05;
  b.spacing = 0.04;
  b.density = b.stiffness = 20;
  b.inertia = 1;
  b.cfl = 0.5;
  b.growth = OrientedGrowth::Gaps;
  b.gap = 1.75;
  b.damping = b.spinDamping = 12;
  b.facing = false;
  for (const Vec3d& at : {Vec3d{-0.6, 0, 0}, Vec3d{0.6, 0, 0}, Vec3d{0, 0, 0.05}}) {
    OrientedConstraint a;
    a.region = test::boxOf(at - Vec3d{0.0175, 0.05, 0.1}, at + Vec3d{0.0175, 0.05, 0.1});
    b.constraints.push_back(a);
  }
  b.constraints[0].normal = true;
  b.constraints[2].motion = {{0, {}, {}}, {2, {0, 0, 0.45}, {}}};
  s.end = 3;
  test::Simulation x(s);
  const std::size_t before = x.w.oriented.rows.owned;
  ASSERT_TRUE(x.run());
  const Oriented& o = x.w.oriented.rows;
  EXPECT_GT(o.owned, before + 3);
  std::vector<Vec3d> along(o.position.data(), o.position.data() + o.owned);
  std::sort(along.begin(), along.end(), [](const Vec3d& a, const Vec3d& c) { return a.x < c.x; });
  for (std::size_t k = 1; k < along.size(); k++) {
    EXPECT_GT(length(along[k] - along[k - 1]), 0.9 * 0.04);
    EXPECT_LT(length(along[k] - along[k - 1]), 1.1 * 0.04);
  }
}

// Control points replace the nearest lattice particles. Neighbours half a spacing apart would burst the
// unrelaxed plate.
TEST(Oriented, ThinPlateThroughControlPointsHoldsWithoutRelaxation) {
  Scene s = patchScene(0);
  OrientedBody& b = s.oriented[0];
  b.source = OrientedSource::Control;
  b.points = {{-0.31, -0.3, 0},    {0.33, -0.28, 0.05},  {-0.3, 0.32, 0.06},
              {0.29, 0.31, -0.02}, {0.024, 0.013, 0.12}, {0.17, -0.11, 0.07}};
  b.damping = b.spinDamping = 5;
  s.end = 0.5;
  test::Simulation x(s);
  const Oriented& o = x.w.oriented.rows;
  const std::size_t before = o.owned;
  double nearest = 1;
  for (std::size_t i = 0; i < o.owned; i++)
    for (std::size_t j = 0; j < i; j++) nearest = std::min(nearest, length(o.position[i] - o.position[j]));
  EXPECT_GT(nearest, 0.75 * s.spacing);
  ASSERT_TRUE(x.run());
  ASSERT_EQ(o.owned, before);
  for (std::size_t i = 0; i < o.owned; i++) {  // no particle is isolated
    nearest = 1;
    for (std::size_t j = 0; j < o.owned; j++)
      if (i != j) nearest = std::min(nearest, length(o.position[i] - o.position[j]));
    EXPECT_TRUE((o.flags[i] & fixedPosition) || nearest < 1.2 * s.spacing) << i;
  }
}

}  // namespace
}  // namespace thaw
