// SPDX-License-Identifier: Apache-2.0
// The ledger records the energy of breaking bonds.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/simulation.hpp"

namespace thaw {
namespace {

using test::Simulation;

/// A bar that rotates so fast that it breaks. Returns the unexplained share of its energy.
double lostByBreaking(double dt) {
  Scene s = test::emptyScene(0.02, {-1, -1, -1}, {1, 1, 1});
  s.numerics.elasticPrecision = Precision::Double;
  s.numerics.fixedStep = dt;
  Material m;
  m.density = 1000;
  m.young = {2e5, 0};
  m.poisson = {0.3, 0.3};
  m.breakStretch = 1.06;
  s.materials.push_back(m);
  test::addBox(s, {-0.2, -0.03, -0.03}, {0.2, 0.03, 0.03}).spin = {0, 0, 40};
  s.end = 0.03;
  Simulation r(s);
  const double kinetic = r.ledgerReport().now.kinetic;
  EXPECT_TRUE(r.run());
  EXPECT_GT(r.w.counters.brokenBonds, 100);
  EXPECT_GT(r.ledgerReport().phaseJump, 0.005 * kinetic);
  return r.ledgerReport().energyResidual / kinetic;
}

// Forces change at the end of a step. A break recorded as the bond energy alone would leave out the energy of
// the kick. That energy is of first order.
TEST(BreakingEnergy, IsRecordedToSecondOrder) {
  const double whole = std::abs(lostByBreaking(1e-4)), half = std::abs(lostByBreaking(5e-5));
  EXPECT_LT(whole, 1e-3);
  EXPECT_LT(half, 0.4 * whole);
}

}  // namespace
}  // namespace thaw
