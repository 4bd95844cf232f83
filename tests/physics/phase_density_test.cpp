// SPDX-License-Identifier: Apache-2.0
// Materials whose solid and liquid differ in density: volumes, floating, level and energy.
#include <gtest/gtest.h>

#include <cmath>

#include "core/materials/rest_density.hpp"
#include "tests/support/rigid/scenes.hpp"

namespace thaw::test {
namespace {

constexpr double dx = 0.02;

/// Ice that melts at 273 K.
Material ice() {
  Material m = rigidWax();
  m.name = "ice";
  m.density = 1000;
  m.solidDensity = 917;
  m.solidus = 272;
  m.liquidus = 274;
  m.hysteresis = 0.2;
  m.viscosity = {2, 2};
  return m;
}

/// A column of `layers` layers of a material on a floor under gravity, of temperature T (K).
Scene column(const Material& m, int layers, double T) {
  Scene s = columnScene(dx, 0, 2 * layers * dx);
  s.domain.side[2] = {Side::Wall, Side::Open};
  s.domain.gravity = {0, 0, -9.81};
  s.materials[0] = m;
  addBox(s, {0, 0, 0}, {6 * dx, 6 * dx, layers * dx}).temperature = T;
  return s;
}

/// Brings all particles to a temperature (K) from `start` on.
void temper(Scene& s, double start, double over, double T) {
  s.thermostats.emplace_back();
  s.thermostats.back().start = start;
  s.thermostats.back().over = over;
  s.thermostats.back().temperature = T;
}

/// Numerics that scene files choose for liquids.
Numerics carried() {
  Numerics n;
  n.density = DensityForm::Continuity;
  n.shifting = 0.07;
  n.tensileLimit = 1;
  return n;
}

/// Height (m) of the centre of mass.
double meanHeight(const Continuum& p) {
  double moment = 0, mass = 0;
  for (std::size_t i = 0; i < p.owned; i++) moment += p.mass[i] * p.position[i].z, mass += p.mass[i];
  return moment / mass;
}

/// Mean of meanHeight over the last tenth of the scene's time.
double finalMeanHeight(Simulation& sim) {
  double sum = 0;
  int count = 0;
  while (sim.w.clock.time < sim.w.clock.end) {
    if (!sim.step()) return NAN;
    if (sim.w.clock.time < 0.9 * sim.w.clock.end) continue;
    sum += meanHeight(sim.particles());
    count++;
  }
  return sum / count;
}

double residualOf(const LedgerReport& r) { return std::abs(r.energyResidual) / r.energyScale; }

}  // namespace

TEST(PhaseDensity, VolumesOfBothPhasesAddUp) {
  Material m = ice();
  EXPECT_EQ(targetRestDensity(m, Solid, 0), 917);
  EXPECT_EQ(targetRestDensity(m, Solid, 0.7), 917) << "a solid keeps its volume until it melts";
  EXPECT_EQ(targetRestDensity(m, Liquid, 1), 1000);
  EXPECT_NEAR(targetRestDensity(m, Liquid, 0.2), 917, 1e-9) << "the density of the solid where it freezes";
  EXPECT_NEAR(1 / targetRestDensity(m, Liquid, 0.6), 0.5 / 917 + 0.5 / 1000, 1e-12);
  m.solidDensity = 0;
  EXPECT_EQ(targetRestDensity(m, Solid, 0), 1000);
  EXPECT_EQ(targetRestDensity(m, Liquid, 0.3), 1000);
}

TEST(PhaseDensity, OnlyScenesWithSolidsOfAnotherDensityHaveTheField) {
  Scene s = column(ice(), 4, 260);
  s.end = 1;
  EXPECT_TRUE(Simulation(s).particles().restDensity.active);
  s.materials[0].solidDensity = 0;
  EXPECT_FALSE(Simulation(s).particles().restDensity.active);
  s.materials[0].solidDensity = 917;
  s.bodies[0].temperature = 300;
  EXPECT_FALSE(Simulation(s).particles().restDensity.active) << "nothing can freeze without heat";
}

TEST(PhaseDensity, BothPhasesStartWithTheVolumeOfACell) {
  Scene s = column(ice(), 4, 260);
  addBox(s, {0, 0, 4 * dx}, {6 * dx, 6 * dx, 8 * dx}).temperature = 300;
  s.materials[0].conductivity = {1, 1};
  s.end = 1;
  Simulation sim(s);
  const Continuum& p = sim.particles();
  for (std::size_t i = 0; i < p.owned; i++) {
    EXPECT_NEAR(p.mass[i], (p.phase[i] == Solid ? 917 : 1000) * dx * dx * dx, 1e-12);
    EXPECT_NEAR(p.mass[i] / restDensityOf(p, s.materials, i), dx * dx * dx, 1e-18);
  }
}

/// Melts a column of a solid on a floor. Returns the ratio of its heights after and before.
double growthOfMelt(const Material& m, const Numerics& n, double& residual) {
  Scene s = column(m, 30, 260);
  temper(s, 0.1, 0.2, 300);
  s.numerics = n;
  s.end = 1.5;
  Simulation sim(s);
  const double before = meanHeight(sim.particles()), mass = totalMass(sim.w.particles, sim.all);
  const double after = finalMeanHeight(sim);
  EXPECT_EQ(sim.w.counters.melted, static_cast<std::int64_t>(sim.particles().owned));
  EXPECT_EQ(totalMass(sim.w.particles, sim.all), mass);
  residual = residualOf(sim.ledgerReport());
  return after / before;
}

TEST(PhaseDensity, MeltGrowsByTheRatioOfDensities) {
  Material wax = ice();
  wax.solidDensity = 900;
  wax.density = 780;
  double residual = 1;
  EXPECT_NEAR(growthOfMelt(ice(), carried(), residual), 0.917, 0.01 * 0.917);
  EXPECT_LT(residual, 0.01);
  EXPECT_NEAR(growthOfMelt(wax, carried(), residual), 900.0 / 780, 0.01 * 900 / 780);
  EXPECT_LT(residual, 0.01);
  EXPECT_NEAR(growthOfMelt(wax, {}, residual), 900.0 / 780, 0.01 * 900 / 780) << "summed density";
  EXPECT_LT(residual, 0.02);
}

/// Freezes a column of melt on a floor. Returns the ratio of its heights after and before.
double growthOfSolid(const Material& m, double& residual) {
  Scene s = column(m, 30, 300);
  temper(s, 0.5, 1, 260);
  s.numerics = carried();
  s.end = 2.5;
  Simulation sim(s);
  const double before = meanHeight(sim.particles());
  const double after = finalMeanHeight(sim);
  EXPECT_EQ(sim.w.counters.frozen, static_cast<std::int64_t>(sim.particles().owned));
  residual = residualOf(sim.ledgerReport());
  return after / before;
}

TEST(PhaseDensity, FreezingMeltShrinksOrGrowsByTheRatioOfDensities) {
  double residual = 1;
  EXPECT_NEAR(growthOfSolid(ice(), residual), 1 / 0.917, 0.01);
  EXPECT_LT(residual, 0.01);
  Material wax = ice();
  wax.solidDensity = 900;
  wax.density = 780;
  EXPECT_NEAR(growthOfSolid(wax, residual), 780.0 / 900, 0.02);
  EXPECT_LT(residual, 0.01);
  wax.law.name = "neo-hookean";
  wax.young = {3e5, 0};
  wax.poisson = {0.3, 0.3};
  EXPECT_NEAR(growthOfSolid(wax, residual), 780.0 / 900, 0.03)
      << "an elastic solid, which its weight shortens by 0.7 %";
  EXPECT_LT(residual, 0.01);
}

/// A tank of water with a cube of ice of ten particles a side in it, which melts from 1 s on.
struct Tank {
  static constexpr double edge = 10 * dx, width = 18 * dx, depth = 13 * dx, area = width * width;
  Simulation sim;
  double exactLevel;  ///< m, of all the mass as liquid

  static Scene scene() {
    Scene s = emptyScene(dx, {0, 0, 0}, {width, width, 2 * depth});
    s.domain.gravity = {0, 0, -9.81};
    for (auto& side : s.domain.side) side = {Side::Wall, Side::Wall};
    s.domain.side[2][1] = Side::Open;
    s.materials.push_back(ice());
    s.materials[0].bulkDamping = 0.02;
    s.numerics = carried();
    s.numerics.overlap = OverlapRule::RemoveEarlier;
    addBox(s, {0, 0, 0}, {width, width, depth}).temperature = 300;
    addBox(s, {4 * dx, 4 * dx, depth - 9 * dx}, {14 * dx, 14 * dx, depth + dx}).temperature = 260;
    temper(s, 1, 0.5, 300);
    s.end = 2.4;
    return s;
  }
  Tank() : sim(scene()), exactLevel(totalMass(sim.w.particles, sim.all) / 1000 / area) {}

  /// Draught of the cube divided by its edge. The water level around the cube follows from the volume of
  /// water.
  double draught() {
    const Continuum& p = sim.particles();
    double water = 0;
    for (std::size_t i = 0; i < p.owned; i++)
      if (p.phase[i] == Liquid) water += p.mass[i] / restDensityOf(p, sim.w.scene.materials, i);
    const double low = sim.w.pieces.centre[0].z - edge / 2;
    return ((water - edge * edge * low) / (area - edge * edge) - low) / edge;
  }
  /// Steps until `end` (s). Returns the mean of measure() from `from` (s) on.
  template<class Measure> double meanUntil(double from, double end, Measure measure) {
    double sum = 0;
    int count = 0;
    while (sim.w.clock.time < end) {
      if (!sim.step()) return NAN;
      if (sim.w.clock.time < from) continue;
      sum += measure();
      count++;
    }
    return sum / count;
  }
};

TEST(PhaseDensity, IceFloatsInItsMeltAndTheLevelStaysWhenItMelts) {
  Tank tank;
  const double mass = totalMass(tank.sim.w.particles, tank.sim.all);
  EXPECT_NEAR(tank.meanUntil(0.4, 1, [&] { return tank.draught(); }), 0.917, 0.02 * 0.917);
  const double level = tank.meanUntil(2, 2.4, [&] { return 2 * meanHeight(tank.sim.particles()); });
  EXPECT_EQ(tank.sim.w.counters.melted, 1000);
  EXPECT_NEAR(level, tank.exactLevel, 0.005 * tank.exactLevel);
  EXPECT_EQ(totalMass(tank.sim.w.particles, tank.sim.all), mass);
  EXPECT_LT(residualOf(tank.sim.ledgerReport()), 0.01);
}

}  // namespace thaw::test
