// SPDX-License-Identifier: Apache-2.0
// The ledger closes for a plastic ball that hits a floor at half of its wave speed.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/simulation.hpp"

namespace thaw {
namespace {

using test::Simulation;

/// Returns the unexplained energy of the impact over the kinetic energy before it.
double lostInImpact(const char* law, double maxPlasticStrain) {
  Scene s = test::emptyScene(0.01, {0, 0, 0}, {0.4, 0.4, 0.3});
  s.domain.side[2][0] = Side::Wall;
  Material m;
  m.density = 1200;
  m.young = {5e4, 0};
  m.poisson = {0.3, 0.3};
  m.law.name = law;
  m.yieldStrain = {0.02, 0.02};
  m.creepRate = {never, never};
  m.maxPlasticStrain = maxPlasticStrain;
  s.materials.push_back(m);
  Body& ball = test::addBox(s, {0.15, 0.15, 0.02}, {0.25, 0.25, 0.12});
  ball.velocity = {0, 0, -3.5};
  s.end = 0.06;
  Simulation r(s);
  const double kinetic = r.ledgerReport().now.kinetic;
  EXPECT_TRUE(r.run());
  EXPECT_GT(r.ledgerReport().dissipated, 0.2 * kinetic);
  return r.ledgerReport().energyResidual / kinetic;
}

// Nearly all of the body flows, so most references are renewed while it is compressed.
TEST(PlasticImpact, LedgerClosesWithNewReferences) {
  for (const char* const law : {"neo-hookean", "corotated"})
    EXPECT_NEAR(lostInImpact(law, never), 0, 0.01) << law;
}

// Past the limit the stress changes by a multiple of the yield stress in a step.
TEST(PlasticImpact, LedgerClosesAtTheLimitOfPlasticStrain) {
  for (const char* const law : {"neo-hookean", "corotated"})
    EXPECT_NEAR(lostInImpact(law, 0.3), 0, 0.01) << law;
}

}  // namespace
}  // namespace thaw
