// SPDX-License-Identifier: Apache-2.0
// Heat against exact solutions over whole steps.
#include <gtest/gtest.h>

#include <cmath>

#include "core/materials/enthalpy.hpp"
#include "tests/support/simulation.hpp"

namespace thaw::test {
namespace {

constexpr double dx = 0.01;

/// A column of liquid at rest along z, 0 to n spacings.
Scene liquidColumn(int n) {
  Scene s = columnScene(dx, -4 * dx, (n + 4) * dx);
  Material& m = s.materials[0];
  m.soundSpeed = 0.25;  // the material does not move
  m.conductivity = {1000, 1000};
  m.viscosity = {1, 1};
  return s;
}

Thermostat temper(double start, double over, double temperature) {
  Thermostat t;
  t.start = start;
  t.over = over;
  t.temperature = temperature;
  return t;
}

}  // namespace

TEST(HeatConduction, TwoSlabsInContactFollowTheErrorFunction) {
  Scene s = liquidColumn(40);
  addBox(s, {0, 0, 0}, {6 * dx, 6 * dx, 20 * dx}).temperature = 300;
  addBox(s, {0, 0, 20 * dx}, {6 * dx, 6 * dx, 40 * dx}).temperature = 400;
  s.numerics.precision = Precision::Double;
  const double alpha = 1000 / (1000 * 1000.0);
  s.end = 9 * dx * dx / alpha;  // 2 sqrt(alpha t) = 6 spacings
  Simulation run(s);
  ASSERT_EQ(run.particles().owned, 36u * 40);
  EXPECT_TRUE(run.run());
  double square = 0;
  for (std::size_t i = 0; i < run.particles().owned; i++) {
    const double exact = 350 + 50 * std::erf((run.particles().position[i].z - 20 * dx) / (6 * dx));
    square += std::pow((run.particles().temperature[i] - exact) / 100, 2);
  }
  EXPECT_LT(std::sqrt(square / static_cast<double>(run.particles().owned)), 6e-3);
  const LedgerReport r = run.ledgerReport();
  EXPECT_LT(std::abs(r.heatResidual), 1e-12 * r.now.internal);
  EXPECT_EQ(r.heatIn, 0);
}

TEST(HeatSource, WarmsAtItsRate) {
  Scene s = liquidColumn(6);
  s.materials[0].heatSource = 500;  // W/kg: 0.5 K/s
  addBox(s, {0, 0, 0}, {6 * dx, 6 * dx, 6 * dx}).temperature = 300;
  s.end = 4;
  Simulation run(s);
  EXPECT_TRUE(run.run());
  for (std::size_t i = 0; i < run.particles().owned; i++)
    EXPECT_NEAR(run.particles().temperature[i], 302, 1e-8);
  EXPECT_NEAR(run.ledgerReport().heatIn, 500 * 4 * run.ledgerReport().now.mass, 1e-6);
}

TEST(Thermostat, BringsOneMaterialToItsTemperatureAndRecordsTheHeat) {
  Scene s = liquidColumn(6);
  s.materials[0].conductivity = {0, 0};
  addBox(s, {0, 0, 0}, {6 * dx, 6 * dx, 6 * dx}).temperature = 300;
  s.thermostats = {temper(1, 0.5, 280)};
  s.thermostats[0].material = 0;
  s.end = 1.25;
  Simulation run(s);
  EXPECT_TRUE(run.run());
  // half-way
  for (std::size_t i = 0; i < run.particles().owned; i++)
    EXPECT_NEAR(run.particles().temperature[i], 290, 1e-6);
  s.end = 2;
  Simulation whole(s);
  EXPECT_TRUE(whole.run());
  for (std::size_t i = 0; i < whole.particles().owned; i++)
    EXPECT_NEAR(whole.particles().temperature[i], 280, 1e-9);
  const LedgerReport r = whole.ledgerReport();
  EXPECT_NEAR(r.heatIn, -20 * 1000 * r.now.mass, 1e-6 * std::abs(r.heatIn));
  EXPECT_LT(std::abs(r.heatResidual), 1e-12 * r.now.internal);
}

TEST(Thermostat, TakesOneStepWithoutADuration) {
  Scene s = liquidColumn(6);
  addBox(s, {0, 0, 0}, {6 * dx, 6 * dx, 6 * dx}).temperature = 300;
  s.thermostats = {temper(0.2, 0, 310)};
  s.end = 1;
  Simulation run(s);
  EXPECT_TRUE(run.run());
  for (std::size_t i = 0; i < run.particles().owned; i++)
    EXPECT_NEAR(run.particles().temperature[i], 310, 1e-9);
}

// K05's model counts c T from 0 K, including the heat of the initial state and of emitters.
TEST(Thermostat, LeavesNoResidualInThePapersModel) {
  Scene s = liquidColumn(12);
  s.numerics.heat = HeatModel::Paper;
  Material& m = s.materials[0];
  m.solidus = 280;
  m.liquidus = 320;
  m.latentHeat = 1e4;
  m.paperDiffusivity = 1e-4f;
  m.soundSpeed = 10;
  addBox(s, {0, 0, 0}, {6 * dx, 6 * dx, 4 * dx}).temperature = 330;
  s.emitters.emplace_back();
  Emitter& e = s.emitters[0];
  e.radius = 2 * dx;
  e.centre = {3 * dx, 3 * dx, 11 * dx};
  e.speed = 1;
  e.temperature = 350;
  s.thermostats = {temper(0.1, 0.05, 290)};
  s.end = 0.25;
  Simulation run(s);
  EXPECT_TRUE(run.run());
  const LedgerReport r = run.ledgerReport();
  EXPECT_GT(run.w.counters.emitted, 30);
  EXPECT_LT(r.heatIn, -1e3 * r.initial.mass);
  EXPECT_LT(std::abs(r.heatResidual), 1e-12 * r.now.internal);
}

}  // namespace thaw::test
