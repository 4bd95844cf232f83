// SPDX-License-Identifier: Apache-2.0
// Heat between bodies with a contact conductance against exact solutions.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/simulation.hpp"

namespace thaw::test {
namespace {

constexpr double dx = 0.01;
constexpr int half = 8;  // spacings, thickness of a slab

/// Two clamped slabs of different solids between plates of 400 and 300 K at z = 0 and 16 spacings.
Scene slabs(double conductance) {
  Scene s = columnScene(dx, -4 * dx, (2 * half + 4) * dx);
  s.numerics.precision = Precision::Double;
  Material& m = s.materials[0];
  m.young = {1, 0};
  m.conductivity = {1000, 1000};
  m.contactConductance = conductance;
  s.materials.push_back(m);
  s.materials[1].name = "other";
  s.materials[1].conductivity = {400, 400};
  s.materials[1].contactConductance = 10 * conductance;  // the smaller one counts
  addBox(s, {0, 0, 0}, {6 * dx, 6 * dx, half * dx}).temperature = 400;
  Body& upper = addBox(s, {0, 0, half * dx}, {6 * dx, 6 * dx, 2 * half * dx});
  upper.material = 1;
  upper.temperature = 300;
  for (Body& b : s.bodies) b.clamp = {b.shape};
  addFloor(s).temperature = 400;
  addFloor(s).temperature = 300;
  s.obstacles[1].name = "lid";
  s.obstacles[1].shape.point = {0, 0, 2 * half * dx};
  s.obstacles[1].shape.normal = {0, 0, -1};
  return s;
}

/// Mean temperature of the particles of a layer of the lattice.
double layerTemperature(const Continuum& p, int layer) {
  double sum = 0;
  int n = 0;
  for (std::size_t i = 0; i < p.owned; i++)
    if (static_cast<int>(std::floor(p.position[i].z / dx)) == layer) sum += p.temperature[i], n++;
  return sum / n;
}

}  // namespace

TEST(ContactHeat, SteadyFlowPassesTheResistancesInSeries) {
  constexpr double L = half * dx, k1 = 1000, k2 = 400;
  for (const double h : {2e3, 2e4, 2e5}) {  // 40, 4 and 0.4 of k1 / L2
    Scene s = slabs(h);
    s.end = 40;  // 25 times the slowest decay without the contact
    Simulation run(s);
    ASSERT_TRUE(run.w.modules.contactConductance);
    ASSERT_TRUE(run.run());
    const double exact = 100 / (L / k1 + 1 / h + L / k2);
    const Continuum& p = run.particles();
    const double lower = k1 * (layerTemperature(p, 1) - layerTemperature(p, half - 2)) / ((half - 3) * dx),
                 upper = k2 * (layerTemperature(p, half + 1) - layerTemperature(p, 2 * half - 2)) /
                         ((half - 3) * dx);
    EXPECT_NEAR(lower / exact, 1, 0.02) << h;
    EXPECT_NEAR(upper / exact, 1, 0.02) << h;
    const double jump = layerTemperature(p, half - 1) - layerTemperature(p, half) -
                        0.5 * dx * exact * (1 / k1 + 1 / k2);
    EXPECT_NEAR(jump / (exact / h), 1, 0.02) << h;
  }
}

TEST(ContactHeat, IsBalancedToRounding) {
  Scene s = slabs(3e4);
  s.numerics.precision = Precision::Single;
  s.obstacles.clear();
  s.end = 4;
  Simulation run(s);
  ASSERT_TRUE(run.run());
  const LedgerReport r = run.ledgerReport();
  EXPECT_EQ(r.heatIn, 0);
  EXPECT_LT(std::abs(r.heatResidual), 1e-13 * r.now.internal);
  EXPECT_LT(layerTemperature(run.particles(), half - 1), 399);
}

TEST(ContactHeat, PerfectContactHasTheBitsOfOneBody) {
  Scene s = slabs(never);
  s.end = 2;
  Simulation without(s);
  EXPECT_FALSE(without.w.modules.contactConductance);
  s.materials[0].contactConductance = 1e300;
  Simulation with(s);
  EXPECT_TRUE(with.w.modules.contactConductance);
  ASSERT_TRUE(without.run() && with.run());
  for (std::size_t i = 0; i < with.particles().owned; i++)
    EXPECT_NEAR(with.particles().temperature[i], without.particles().temperature[i], 1e-10);
}

TEST(ContactHeat, DoesNotCrossAGap) {
  for (const double gap : {0.1, 0.5}) {  // spacings
    Scene s = slabs(1e6);
    s.obstacles.clear();
    for (Body& b : s.bodies) b.clamp = {};
    s.bodies[1].shape.move.z += gap * dx;
    s.end = 4;
    Simulation run(s);
    ASSERT_TRUE(run.run());
    const Continuum& p = run.particles();
    double warmest = 0;
    for (std::size_t i = 0; i < p.owned; i++)
      if (p.body[i] == 1) warmest = std::max(warmest, p.temperature[i]);
    if (gap < 0.2) EXPECT_GT(warmest, 320);
    else EXPECT_EQ(warmest, 300);
  }
}

TEST(ContactHeat, LiquidsOfTwoBodiesHaveNoResistance) {
  Scene s = slabs(1);
  for (Material& m : s.materials) m.young = {}, m.viscosity = {1, 1}, m.soundSpeed = 0.01;
  s.obstacles.clear();
  s.end = 2;
  Simulation with(s);
  for (Material& m : s.materials) m.contactConductance = never;
  Simulation without(s);
  ASSERT_TRUE(without.run() && with.run());
  for (std::size_t i = 0; i < with.particles().owned; i++)
    EXPECT_NEAR(with.particles().temperature[i], without.particles().temperature[i], 1e-10);
}

}  // namespace thaw::test
