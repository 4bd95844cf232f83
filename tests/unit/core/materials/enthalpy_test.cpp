// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "core/heat/heat.hpp"
#include "core/materials/enthalpy.hpp"
#include "core/simulation/views/views.hpp"

namespace thaw::test {
namespace {

Material wax() {
  Material m;
  m.young = {1e6, 0};
  m.heatCapacity = {2000, 2500};
  m.latentHeat = 2e5;
  m.solidus = 320;
  m.liquidus = 330;
  m.conductivity = {1, 1};
  return m;
}

/// One particle of a material, with the columns of heat.
struct Lump {
  World w;
  explicit Lump(const Material& m, double T) {
    w.scene.materials.push_back(m);
    w.scene.bodies.emplace_back();
    w.modules.heat = w.modules.melting = true;
    Continuum& p = w.particles;
    for (AnyColumn* c : p.columns) p.activate(*c);
    p.resize(1, 0);
    p.mass[0] = 2;
    p.solidIndex[0] = noSolid;
    p.enthalpy[0] = enthalpyOf(m, T);
    p.temperature[0] = T;
    setPhase(w.scene, w.modules, p, 0, 1);
  }
  Continuum& p() { return w.particles; }
  /// Exposes the area of a particle.
  void expose(double spacing, double ambient) {
    w.modules.surfaceHeat = true;
    w.scene.spacing = spacing;
    w.scene.domain.ambient = ambient;
    p().exposedArea[0] = 1;
    p().heatFlow[0] = 0;
  }
  void setFraction(double f) {
    p().enthalpy[0] = f * meltingBand(w.scene.materials[0]);
    p().heatFlow[0] = 0;
    updateHeat(heatView(w), 1);
  }
};

}  // namespace

TEST(Enthalpy, IsTheInverseOfTemperature) {
  const Material m = wax();
  for (double T : {1.0, 250.0, 319.999, 320.0, 322.0, 329.9, 330.0, 400.0, 3000.0})
    EXPECT_NEAR(thermalOf(m, enthalpyOf(m, T)).temperature, T, 1e-10 * T);
  for (double H : {-5e5, -1.0, 0.0, 1e5, 2.2e5, 2.3e5, 1e6})
    EXPECT_NEAR(enthalpyOf(m, thermalOf(m, H).temperature), H, 1e-6);
}

TEST(Enthalpy, RisesContinuouslyWithTemperature) {
  const Material m = wax();
  double before = enthalpyOf(m, 250), fraction = 0;
  for (double T = 250.01; T < 400; T += 0.01) {
    const double H = enthalpyOf(m, T), f = thermalOf(m, H).liquid;
    EXPECT_GT(H, before);
    EXPECT_LT(H - before, 0.02 * (m.latentHeat / 10 + 2500));
    EXPECT_GE(f, fraction);
    before = H;
    fraction = f;
  }
  EXPECT_EQ(fraction, 1);
  // enthalpy from 300 K to 350 K
  EXPECT_NEAR(enthalpyOf(m, 350) - enthalpyOf(m, 300), 20 * 2000 + 10 * 2250 + 2e5 + 20 * 2500, 1e-6);
}

TEST(Enthalpy, PureSubstanceStaysAtItsMeltingPoint) {
  Material m = wax();
  m.liquidus = m.solidus = 300;
  for (double f : {0.0, 0.25, 0.5, 1.0}) {
    const Thermal t = thermalOf(m, enthalpyOf(m, 300, f));
    EXPECT_DOUBLE_EQ(t.temperature, 300);
    EXPECT_DOUBLE_EQ(t.liquid, f);
  }
  EXPECT_DOUBLE_EQ(thermalOf(m, m.latentHeat + 2500).temperature, 301);
  m.latentHeat = 0;  // no melting range
  EXPECT_EQ(thermalOf(m, 0).liquid, 1);
  EXPECT_EQ(thermalOf(m, -1e-9).liquid, 0);
}

TEST(Enthalpy, MaterialsMayHaveNoMeltingPoint) {
  Material m;
  m.heatCapacity = {500, 4000};
  EXPECT_EQ(thermalOf(m, enthalpyOf(m, 321)).liquid, 1);  // no elasticity: a liquid
  EXPECT_DOUBLE_EQ(enthalpyOf(m, 321), 321 * 4000);
  m.young = {1, 1};
  EXPECT_EQ(thermalOf(m, enthalpyOf(m, 321)).liquid, 0);
  EXPECT_DOUBLE_EQ(enthalpyOf(m, 321), 321 * 500);
}

// Heating at a constant rate: the plateau takes L / rate.
TEST(Heat, LatentHeatPlateau) {
  Material m = wax();
  m.liquidus = m.solidus;
  Lump l(m, 310);
  const double dt = 0.1, watts = 2 * 1000;  // 1000 W/kg
  double start = -1, end = -1, taken = 0;
  for (int k = 1; end < 0 && k < 100000; k++) {
    l.p().heatFlow[0] = watts;
    updateHeat(heatView(l.w), dt);
    taken += watts * dt;
    if (start < 0 && l.p().temperature[0] >= m.solidus) start = k * dt;
    if (l.p().temperature[0] > m.solidus) end = k * dt;
  }
  EXPECT_NEAR(start, 10 * 2000 / 1000.0, 2 * dt);
  EXPECT_NEAR(end - start, m.latentHeat / 1000, 2 * dt);
  EXPECT_NEAR(2 * (l.p().enthalpy[0] - enthalpyOf(m, 310)), taken, 1e-6);
}

TEST(Phase, MeltsAtOneAndFreezesAtZero) {
  Lump l(wax(), 300);
  EXPECT_EQ(l.p().phase[0], Solid);
  for (double f : {0.2, 0.9, 0.5, 0.999}) {
    l.setFraction(f);
    EXPECT_FALSE(changePhase(l.w.scene, l.w.particles, l.w.counters).melted);
  }
  l.setFraction(1.0001);
  EXPECT_TRUE(changePhase(l.w.scene, l.w.particles, l.w.counters).melted);
  EXPECT_EQ(l.p().phase[0], Liquid);
  for (double f : {0.99, 0.5, 0.001}) {
    l.setFraction(f);
    const PhaseChanges c = changePhase(l.w.scene, l.w.particles, l.w.counters);
    EXPECT_FALSE(c.melted || c.frozen);
  }
  l.setFraction(-0.01);
  EXPECT_TRUE(changePhase(l.w.scene, l.w.particles, l.w.counters).frozen);
  EXPECT_EQ(l.p().justFrozen[0], 1);
  changePhase(l.w.scene, l.w.particles, l.w.counters);
  EXPECT_EQ(l.p().justFrozen[0], 0);
  EXPECT_EQ(l.w.counters.melted, 1);
  EXPECT_EQ(l.w.counters.frozen, 1);
}

// docs/validation/stability.md, row 14: an oscillating fraction does not change the phase.
TEST(Phase, HysteresisKeepsThePhaseOfOscillatingFractions) {
  Material m = wax();
  m.hysteresis = 0.3;  // melts at 0.7, freezes at 0.3
  Lump l(m, 300);
  const auto flips = [&](double f) {
    l.setFraction(f);
    const PhaseChanges c = changePhase(l.w.scene, l.w.particles, l.w.counters);
    return c.melted || c.frozen;
  };
  EXPECT_FALSE(flips(0.69));
  EXPECT_TRUE(flips(0.71));
  for (int k = 0; k < 100; k++) EXPECT_FALSE(flips(0.5 + (k % 2 ? 0.19 : -0.19)));
  EXPECT_TRUE(flips(0.29));
  EXPECT_FALSE(flips(0.69));
}

// With a width of zero (0.5) a particle must not freeze and melt at the same fraction.
TEST(Phase, LargestHysteresisStillHasAnOrder) {
  Material m = wax();
  m.hysteresis = 0.5;
  Lump l(m, 300);
  l.setFraction(0.5);
  EXPECT_TRUE(changePhase(l.w.scene, l.w.particles, l.w.counters).melted);
  const PhaseChanges again = changePhase(l.w.scene, l.w.particles, l.w.counters);
  EXPECT_FALSE(again.melted || again.frozen);
}

TEST(Heat, PapersModelHasTheTemperatureAsState) {
  Lump l(wax(), 300);
  l.w.scene.numerics.heat = HeatModel::Paper;
  l.p().heatFlow[0] = 2 * 2000 * 25;
  updateHeat(heatView(l.w), 1);
  EXPECT_DOUBLE_EQ(l.p().temperature[0], 325);
  EXPECT_FLOAT_EQ(l.p().liquid[0], 0.5f);
  EXPECT_DOUBLE_EQ(conductivityOf(
                       HeatModel::Paper,
                       [] {
                         Material m = wax();
                         m.paperDiffusivity = 0.04;
                         return m;
                       }(),
                       1),
                   0.04 * 1000 * 2000);
}

TEST(Heat, InitialPhaseFollowsTheTemperatureWithoutHeat) {
  Lump l(wax(), 300);
  l.w.modules.heat = l.w.modules.melting = false;
  l.w.scene.bodies[0].temperature = 500;
  setPhase(l.w.scene, l.w.modules, l.p(), 0, 1);
  EXPECT_EQ(l.p().phase[0], Liquid);
  l.w.scene.bodies[0].temperature = 300;
  setPhase(l.w.scene, l.w.modules, l.p(), 0, 1);
  EXPECT_EQ(l.p().phase[0], Solid);
}

TEST(Heat, SurfacesFollowNewtonsAndStefansLaws) {
  Material m = wax();
  m.convection = 20;
  m.emissivity = 0.9;
  m.conductivity = {};  // one temperature, up to the surface
  Lump l(m, 600);
  l.expose(0.05, 300);
  addOuterHeat(heatView(l.w), 1e-6);
  const double expected = 0.05 * 0.05 *
                          (20 * (300 - 600.0) + 0.9 * 5.670374419e-8 * (std::pow(300, 4) - std::pow(600, 4)));
  EXPECT_NEAR(l.p().heatFlow[0], expected, 1e-6 * std::abs(expected));
  EXPECT_NEAR(l.w.ledger.heatIn.value(), expected * 1e-6, 1e-12 * std::abs(expected));
  l.p().exposedArea[0] = 0;
  l.p().heatFlow[0] = 0;
  addOuterHeat(heatView(l.w), 1);
  EXPECT_EQ(l.p().heatFlow[0], 0);
}

// The surface lies half a spacing from the particle. Conduction to it equals the heat lost there.
TEST(Heat, SurfacesAreCoolerThanTheirParticles) {
  for (const double conductivity : {0.1, 1.0, 1000.0})
    for (const double ambient : {300.0, 900.0}) {
      Material m = wax();
      m.convection = 20;
      m.emissivity = 0.9;
      m.conductivity = {conductivity, conductivity};
      Lump l(m, 600);
      l.expose(0.05, ambient);
      addOuterHeat(heatView(l.w), 1e-6);
      const double flux = l.p().heatFlow[0] / (0.05 * 0.05), surface = 600 + flux * 0.025 / conductivity;
      const double expected = 20 * (ambient - surface) +
                              0.9 * 5.670374419e-8 * (std::pow(ambient, 4) - std::pow(surface, 4));
      EXPECT_NEAR(flux, expected, 1e-6 * std::abs(expected)) << conductivity << ' ' << ambient;
    }
}

// Conduction replaces the heat of surface particles within a step, so their losses do not decay during the
// step.
TEST(Heat, LossesKeepTheirRateInAStep) {
  Material m;
  m.convection = 100;
  m.heatCapacity = {500, 500};
  Lump l(m, 400);
  l.expose(1, 300);
  addOuterHeat(heatView(l.w), 1);  // a tenth of the heat, at this rate
  EXPECT_NEAR(l.p().heatFlow[0] / (100 * -100.0), 1, 0.005);
}

// Cooling ends at the ambient temperature for any step.
TEST(Heat, SurfacesDoNotOvershoot) {
  Material m;
  m.convection = 1e6;
  m.emissivity = 1;
  Lump l(m, 1000);
  l.w.modules.surfaceHeat = true;
  l.w.scene.domain.ambient = 300;
  l.p().exposedArea[0] = 1;
  for (int k = 0; k < 50; k++) {
    l.p().heatFlow[0] = 0;
    addOuterHeat(heatView(l.w), 100);
    updateHeat(heatView(l.w), 100);
    EXPECT_GE(l.p().temperature[0], 300 - 1e-9);
  }
  EXPECT_NEAR(l.p().temperature[0], 300, 1e-6);
  l.w.scene.domain.ambient = 2000;
  for (int k = 0; k < 50; k++) {
    l.p().heatFlow[0] = 0;
    addOuterHeat(heatView(l.w), 100);
    updateHeat(heatView(l.w), 100);
    EXPECT_LE(l.p().temperature[0], 2000 + 1e-9);
  }
  EXPECT_NEAR(l.p().temperature[0], 2000, 1e-6);
}

TEST(Heat, SourcesHeatByMass) {
  Material m = wax();
  m.heatSource = 50;
  Lump l(m, 300);
  l.p().heatFlow[0] = 0;
  addOuterHeat(heatView(l.w), 2);
  EXPECT_EQ(l.p().heatFlow[0], 100);
  EXPECT_EQ(l.w.ledger.heatIn.value(), 200);
}

}  // namespace thaw::test
