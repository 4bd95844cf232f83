// SPDX-License-Identifier: Apache-2.0
// Free surface and shifting of liquids with carried density (core/fluid/terms/carry.hpp).
#include <gtest/gtest.h>

#include <cmath>

#include "core/flow/density/connected_density.hpp"
#include "core/fluid/terms/carry.hpp"
#include "tests/support/simulation.hpp"

namespace thaw {
namespace {

using test::Simulation;

/// A weightless cube of n^3 particles, in open space or (floor) on a wall.
Scene cubeOf(int n, bool floor) {
  Scene s = test::columnScene(0.1, 0, 1);
  s.domain.min = {-1, -1, floor ? 0.0 : -1};
  s.domain.max = {2, 2, 2};
  s.domain.gravity = {};
  s.obstacles.clear();
  if (floor) s.domain.side[2][0] = Side::Wall;
  s.materials[0].soundSpeed = 10;
  test::carryDensity(s, 0.2);
  s.bodies.clear();
  const double size = 0.1 * n;
  test::addBox(s, {0, 0, 0}, {size, size, size});
  s.end = 0.1;
  return s;
}

TEST(FreeSurface, EigenvaluesAreComparedByDeterminants) {
  using isa_base::LanesD;
  isa_base::Tensor<LanesD> m;  // eigenvalues 1.5, 2.5, 3
  m.xx = m.yy = LanesD(2.0), m.zz = LanesD(3.0), m.xy = LanesD(0.5);
  const auto above = [&](double least) { return laneOf(eigenvaluesAbove(m, LanesD(least)), 0); };
  EXPECT_TRUE(above(1.49));
  EXPECT_FALSE(above(1.51));
  EXPECT_FALSE(above(2.7));  // two eigenvalues are below, so the determinant is positive
}

TEST(FreeSurface, IsTheOutermostLayerWithoutWalls) {
  for (const bool floor : {false, true}) {
    Simulation r(cubeOf(6, floor));
    const Continuum& p = r.particles();
    for (std::size_t i = 0; i < p.owned; i++) {
      const Vec3d x = p.position[i];
      bool outer = x.z > 0.5 || (!floor && x.z < 0.1);
      for (const double a : {x.x, x.y}) outer = outer || a < 0.1 || a > 0.5;
      EXPECT_EQ(p.atSurface[i] != 0, outer) << floor << ' ' << x.x << ' ' << x.y << ' ' << x.z;
    }
  }
}

TEST(FreeSurface, LiquidAtRestIsNotShifted) {
  Simulation r(cubeOf(6, false));
  ASSERT_TRUE(r.run());
  const Continuum& p = r.particles();
  for (std::size_t i = 0; i < p.owned; i++) EXPECT_LT(length(p.shiftingVelocity[i]), 1e-4);
}

/// Mean number of neighbours of particles within 0.2 m of the z axis.
double neighboursInside(const World& w) {
  double sum = 0, count = 0;
  for (std::size_t i = 0; i < w.particles.owned; i++) {
    const Vec3d x = w.particles.position[i];
    if (x.x * x.x + x.y * x.y > 0.04) continue;
    sum += w.neighbours.neighbours[i];
    count++;
  }
  return sum / count;
}

/// A square of liquid, 20 particles wide and periodic across, spins until it has turned by 2 rad.
Scene spinningSquare() {
  Scene s = cubeOf(20, false);
  s.spacing = 0.05;
  s.domain.min = {-2, -2, -0.15};
  s.domain.max = {2, 2, 0.15};
  s.domain.side[2] = {Side::Periodic, Side::Periodic};
  s.bodies.clear();
  test::addBox(s, {-0.5, -0.5, -0.15}, {0.5, 0.5, 0.15}).spin = {0, 0, 5};
  s.materials[0].soundSpeed = 35;
  s.materials[0].viscosity = {};
  s.end = 0.4;
  return s;
}

TEST(FreeSurface, ReportsSummedDensityOfTornLiquids) {
  Scene s = spinningSquare();
  s.numerics.density = DensityForm::Summation;
  s.numerics.tensileLimit = s.numerics.shifting = 0;
  Simulation r(s);
  EXPECT_GT(connectedDensity(r.w.modules, r.w.particles, r.w.neighbours, r.w.counters, r.all), 0.95);
  ASSERT_TRUE(r.run());
  EXPECT_LT(connectedDensity(r.w.modules, r.w.particles, r.w.neighbours, r.w.counters, r.all), 0.7);
}

TEST(FreeSurface, ReportsThinLayersWithCarriedDensities) {
  Scene s = spinningSquare();
  s.bodies[0].shape.size.z = 0.6 * s.spacing;  // a single layer
  s.domain.side[2][0] = s.domain.side[2][1] = Side::Open;
  s.end = 0.01;
  Simulation r(s);
  ASSERT_TRUE(r.w.modules.continuity);
  ASSERT_TRUE(r.run());
  EXPECT_LT(connectedDensity(r.w.modules, r.w.particles, r.w.neighbours, r.w.counters, r.all), 0.85);
}

/// A spinning square stays connected. With summed densities its particles keep 0.4 of their neighbours.
TEST(FreeSurface, SpinningLiquidHoldsTogether) {
  const Scene s = spinningSquare();
  Simulation r(s);
  const double kinetic = r.ledgerReport().now.kinetic, neighbours = neighboursInside(r.w);
  ASSERT_TRUE(r.run());
  EXPECT_LT(std::abs(r.ledgerReport().energyResidual), 0.01 * kinetic);
  EXPECT_NEAR(neighboursInside(r.w), neighbours, 0.1 * neighbours);
  const Continuum& p = r.particles();
  double spin = 0;
  for (std::size_t i = 0; i < p.owned; i++)
    spin += p.position[i].x * p.velocity[i].y - p.position[i].y * p.velocity[i].x;
  const double start = 5.0 / 6 * (1 - 1.0 / 400);  // lattice value per particle
  EXPECT_NEAR(spin / static_cast<double>(p.owned), start, 0.02 * start);
}

}  // namespace
}  // namespace thaw
