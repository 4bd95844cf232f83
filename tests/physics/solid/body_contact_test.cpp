// SPDX-License-Identifier: Apache-2.0
// Elastic solids on others: exact solutions of sliding, static friction and rolling.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/support/simulation.hpp"

namespace thaw {
namespace {

using test::Simulation;

constexpr double dx = 0.02;

/// A fixed slab below z = 0, with gravity of 9.81 m/s^2 into it and `along` (m/s^2) beside it.
Scene slabScene(double friction, double along) {
  Scene s = test::emptyScene(dx, {-0.2, -0.2, -0.1}, {0.8, 0.2, 0.4});
  s.domain.gravity = {along, 0, -9.81};
  Material m;
  m.density = 1000;
  m.young = {5e5, 0};
  m.poisson = {0.3, 0.3};
  m.restitution = 0.3;
  m.friction = friction;
  s.materials.push_back(m);
  Body& slab = test::addBox(s, {-0.1, -0.08, -0.04}, {0.7, 0.08, 0});
  slab.clamp.push_back(slab.shape);
  return s;
}

/// Mean position (m) and velocity (m/s) of the last body.
struct Middle {
  Vec3d position{}, velocity{};
};

Middle middleOf(const Simulation& r) {
  Middle m;
  double count = 0;
  for (std::size_t i = 0; i < r.w.particles.owned; i++) {
    if (r.w.particles.body[i] + 1U != r.w.scene.bodies.size()) continue;
    m.position += r.w.particles.position[i];
    m.velocity += r.w.particles.velocity[i];
    count++;
  }
  return {m.position / count, m.velocity / count};
}

/// A block of 5 x 5 x 3 spacings on the slab, whose lattice does not match.
Body& addBlock(Scene& s) { return test::addBox(s, {0.007, -0.053, 0}, {0.107, 0.047, 0.06}); }

TEST(BodyContact, ABlockSlidesWithoutBumps) {
  Scene s = slabScene(0, 0);
  addBlock(s).velocity = {0.5, 0, 0};
  s.end = 0.3;
  Simulation r(s);
  ASSERT_TRUE(r.run());
  EXPECT_NEAR(middleOf(r).velocity.x, 0.5, 0.002);
  EXPECT_NEAR(middleOf(r).position.z, 0.03, 0.02 * dx);
}

TEST(BodyContact, ABlockOnAnInclineHolds) {
  Scene s = slabScene(0.3, 2);
  addBlock(s);
  s.end = 0.15;
  Simulation r(s);
  const double start = middleOf(r).position.x;
  ASSERT_TRUE(r.run());
  EXPECT_NEAR(middleOf(r).position.x, start, 0.02 * dx);
  const double settled = middleOf(r).position.x;
  r.w.clock.end = 0.3;
  ASSERT_TRUE(r.run());
  EXPECT_NEAR(middleOf(r).position.x, settled, 1e-3 * dx);
}

TEST(BodyContact, ABlockOnAnInclineSlides) {
  Scene s = slabScene(0.3, 5);
  addBlock(s);
  s.end = 0.3;
  Simulation r(s);
  ASSERT_TRUE(r.run());
  const double exact = 0.3 * (5 - 0.3 * 9.81);
  EXPECT_NEAR(middleOf(r).velocity.x, exact, 0.02 * exact);
  const LedgerReport ledger = r.ledgerReport();
  EXPECT_LT(std::abs(ledger.energyResidual), 1e-3 * ledger.dissipated);
}

/// A ball of R / dx = 5 rolls down a slope of 5 degrees. Its height changes by a tenth of a spacing as it
/// rolls.
void expectRolling(Scene& s) {
  Body& ball = test::addBox(s, {}, {});
  ball.shape.kind = ShapeKind::Sphere;
  ball.shape.radius = 0.1;
  ball.shape.move = {0, 0, 0.1};
  s.end = 0.5;
  Simulation r(s);
  ASSERT_TRUE(r.run());
  const double exact = 0.5 * 5.0 / 7 * s.domain.gravity.x * 0.25;
  EXPECT_NEAR(middleOf(r).position.x, exact, 0.2 * exact);
}

TEST(BodyContact, ABallRollsOnASlab) {
  Scene s = slabScene(0.6, 0.86);
  expectRolling(s);
}

TEST(BodyContact, ABallRollsOnAnObstacle) {
  Scene s = slabScene(0.6, 0.86);
  s.bodies.clear();
  test::addFloor(s).friction = 0.6;
  expectRolling(s);
}

// A cylinder that ends at periodic sides touches the floor equally in all of its layers.
TEST(BodyContact, ObstaclesTouchSurfacesAcrossPeriodicSides) {
  Scene s = slabScene(0.6, 0);
  s.bodies.clear();
  test::addFloor(s);
  s.domain.min.y = -0.1, s.domain.max.y = 0.1;
  s.domain.side[1] = {Side::Periodic, Side::Periodic};
  Body& rod = test::addBox(s, {}, {});
  rod.shape.kind = ShapeKind::Cylinder;
  rod.shape.radius = 0.1, rod.shape.height = 0.2;
  rod.shape.rotate = {std::numbers::pi / 2, 0, 0};
  rod.shape.move = {0, 0, 0.1};
  s.end = 0.01;
  Simulation r(s);
  ASSERT_TRUE(r.run());
  const Continuum& p = r.w.particles;
  double nearest = 1, farthest = 0;
  for (std::size_t i = 0; i < p.owned; i++)
    if (p.wallOffset[i] > 0 && std::abs(p.position[i].x) < 0.6 * dx) {
      nearest = std::min(nearest, static_cast<double>(p.wallOffset[i]));
      farthest = std::max(farthest, static_cast<double>(p.wallOffset[i]));
    }
  EXPECT_LT(nearest, 0.49);
  EXPECT_NEAR(farthest, nearest, 1e-4);
}

TEST(BodyContact, ABlockOnAnInclinedObstacleHolds) {
  Scene s = slabScene(0.3, 2);
  s.bodies.clear();
  test::addFloor(s).friction = 0.3;
  addBlock(s);
  s.end = 0.15;
  Simulation r(s);
  ASSERT_TRUE(r.run());
  const double settled = middleOf(r).position.x;
  r.w.clock.end = 0.3;
  ASSERT_TRUE(r.run());
  EXPECT_NEAR(middleOf(r).position.x, settled, 1e-3 * dx);
}

}  // namespace
}  // namespace thaw
