// SPDX-License-Identifier: Apache-2.0
// Liquid that flows past convex edges of obstacles.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/simulation.hpp"

namespace thaw::test {
namespace {

constexpr double spacing = 0.06, width = 6 * spacing;  // m

/// A coarse slab of water that moves in a domain periodic along y.
Scene water(const Vec3d& low, const Vec3d& high, const Vec3d& velocity) {
  Scene s = emptyScene(spacing, {-3, 0, -3}, {3, width, 3});
  s.domain.side[1] = {Side::Periodic, Side::Periodic};
  s.domain.gravity = {0, 0, -9.81};
  carryDensity(s, 0.07);
  s.numerics.cflSound = 0.2;
  s.materials.emplace_back();
  s.materials[0].viscosity = {1e-3, 1e-3};
  addBox(s, low, high).velocity = velocity;
  s.end = 0.4;
  return s;
}

Shape& addBlock(Scene& s, const Vec3d& low, const Vec3d& high) {
  s.obstacles.emplace_back();
  s.obstacles.back().name = "block";
  return s.obstacles.back().shape = boxOf(low, high);
}

/// A flow along a table, and over its edge.
Scene overATable(double speed) {
  Scene s = water({-0.8, 0, 0}, {-0.2, width, 0.3}, {speed, 0, 0});
  addBlock(s, {-3, -25, -1}, {0, 25, 0});
  return s;
}

/// A fall onto an edge, which parts the liquid.
Scene ontoARidge(double speed) {
  Scene s = water({-0.2, 0, 0.05}, {0.3, width, 0.55}, {0, 0, -speed});
  Shape& ridge = addBlock(s, {-0.5, -25, -0.5}, {0.5, 25, 0.5});
  ridge.rotate = {0, 0.25 * std::numbers::pi, 0};
  ridge.move = {0, 0, -std::numbers::sqrt2 / 2};
  return s;
}

/// Returns the unexplained energy over the largest term of the ledger.
double unexplained(const Scene& s) {
  Simulation r(s);
  EXPECT_TRUE(r.run());
  const LedgerReport report = r.ledgerReport();
  return report.energyResidual / report.energyScale;
}

}  // namespace

// With normals of the end of the step, the work of walls at edges would have an error of first order.
TEST(LiquidAtEdges, GainsNoEnergy) {
  EXPECT_LT(std::abs(unexplained(overATable(1))), 0.005);
  for (const double speed : {1.0, 2.0, 3.0}) {
    SCOPED_TRACE(speed);
    EXPECT_LT(std::abs(unexplained(ontoARidge(speed))), 0.01);
  }
}

}  // namespace thaw::test
