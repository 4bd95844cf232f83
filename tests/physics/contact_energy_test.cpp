// SPDX-License-Identifier: Apache-2.0
// The ledger records the dissipation of contacts between solids.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/simulation.hpp"

namespace thaw {
namespace {

using test::Simulation;

/// Two rubber boxes, the upper one turned, collide at 2 m/s. Returns the unexplained share of the kinetic
/// energy after contact.
double lostByBlow(double restitution, double friction, double dt) {
  Scene s;
  s.spacing = 0.02;
  s.domain.gravity = {};
  s.output.every = 0;
  s.numerics.precision = Precision::Double;
  s.numerics.fixedStep = dt;
  Material m;
  m.density = 1000;
  m.young = {2e5, 0};
  m.poisson = {0.3, 0.3};
  m.law.name = "corotated";
  m.restitution = restitution;
  m.friction = friction;
  s.materials.push_back(m);
  test::addBox(s, {-0.06, -0.06, -0.1}, {0.06, 0.06, 0});
  Body& upper = test::addBox(s, {-0.05, -0.04, 0.019}, {0.05, 0.06, 0.119});
  upper.velocity = {0.7, 0, -2};
  upper.spin = {0, 0, 5};
  s.end = 0.03;
  Simulation r(s);
  const double kinetic = r.ledgerReport().now.kinetic;
  EXPECT_TRUE(r.run());
  EXPECT_GT(r.ledgerReport().dissipated, 0.02 * kinetic);
  return r.ledgerReport().energyResidual / kinetic;
}

TEST(ContactEnergy, DashpotsAndFrictionAreRecorded) {
  for (const double restitution : {0.3, 0.9}) {
    const double whole = std::abs(lostByBlow(restitution, 0.4, 5e-5)),
                 half = std::abs(lostByBlow(restitution, 0.4, 2.5e-5));
    EXPECT_LT(whole, 5e-5) << restitution;
    EXPECT_LT(half, 0.7 * whole) << restitution;
  }
}

/// A very soft box with a stiff volume falls on a floor at 1 m/s. A spring by Young's modulus alone is far
/// too soft. The floor would then act as a hard stop, and the error of its work would be large.
TEST(ContactEnergy, ASoftBodyOfStiffVolumeRestsOnSpringsThatBearIt) {
  Scene s;
  s.spacing = 0.02;
  s.output.every = 0;
  Material m;
  m.density = 2000;
  m.young = {1000, 0};
  m.poisson = {0.1, 0.1};
  m.volumeStiffness = 3e5;
  s.materials.push_back(m);
  Body& box = test::addBox(s, {-0.08, -0.08, 0.01}, {0.08, 0.08, 0.17});
  box.velocity = {0, 0, -1};
  test::addFloor(s);
  s.end = 0.1;
  Simulation r(s);
  const double kinetic = r.ledgerReport().now.kinetic;
  EXPECT_TRUE(r.run());
  EXPECT_LT(std::abs(r.ledgerReport().energyResidual), 0.01 * kinetic);
}

}  // namespace
}  // namespace thaw
