// SPDX-License-Identifier: Apache-2.0
// Particles of bodies that are too soft for their impact are pushed out of the floor.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/simulation.hpp"

namespace thaw {
namespace {

using test::Simulation;

// The impact presses with rho v^2 = 4.5 kPa on a body of 0.6 kPa. Particles that are moved out of the floor
// lose energy of their contact. The forces on them do work over the distance.
TEST(CrushedBody, EnergyOfParticlesPushedOutIsRecorded) {
  Scene s = test::emptyScene(0.005, {-0.2, -0.2, -0.05}, {0.2, 0.2, 0.3});
  s.domain.gravity = {0, 0, -9.81};
  Material m;
  m.density = 2000;
  m.young = {600, 0};
  m.poisson = {0.15, 0.15};
  m.law.name = "neo-hookean";
  m.friction = 0.4;
  s.materials.push_back(m);
  test::addBox(s, {-0.025, -0.025, 0.01}, {0.025, 0.025, 0.06}).velocity = {0, 0.5, -1.5};
  test::addFloor(s);
  s.end = 0.3;
  Simulation r(s);
  ASSERT_TRUE(r.run());
  EXPECT_GT(r.w.counters.wallProjections, 100);
  const LedgerReport l = r.ledgerReport();
  EXPECT_LT(std::abs(l.energyResidual), 0.02 * l.energyScale);
  // No particle is deeper in the floor than half a spacing, plus its move in a step.
  for (std::size_t i = 0; i < r.particles().owned; i++) EXPECT_GT(r.particles().position[i].z, -0.004);
}

}  // namespace
}  // namespace thaw
