// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>

#include "core/kernels/lattice.hpp"
#include "core/simulation/time/limits.hpp"
#include "core/time/frame_times.hpp"

namespace thaw::test {
namespace {

/// Steps from 0 to the end as in a run. Returns the number of steps.
int runClock(Clock& c, double dt, std::vector<double>& hits, double& shortest) {
  int steps = 0;
  if (frameDue(c)) hits.push_back(c.time), c.frame++;
  while (c.time < c.end && steps < 1000000) {
    const double d = clip(c, dt);
    EXPECT_GT(d, 0);
    EXPECT_LE(d, dt * (1 + 1e-8));
    shortest = std::min(shortest, d);
    c.time = timeAfter(c, d);
    steps++;
    while (frameDue(c)) hits.push_back(c.time), c.frame++;
  }
  return steps;
}

Scene oneMaterial() {
  Scene s;
  s.spacing = 0.01;
  Material m;
  m.density = 1000;
  m.viscosity = {2, 2};
  m.soundSpeed = 20;
  s.materials.push_back(m);
  s.bodies.emplace_back();
  return s;
}

}  // namespace

TEST(Clock, FrameTimesAndTheEndAreHitExactly) {
  for (double every : {0.04, 0.1, 1 / 3.0, 0.0123456789, 0.7, 2.0})
    for (double dt : {0.04, 0.0399999999999, 0.001, 0.00037, 0.011, 5.0}) {
      Clock c;
      c.end = 1;
      c.every = every;
      std::vector<double> hits;
      double shortest = dt;
      runClock(c, dt, hits, shortest);
      EXPECT_EQ(c.time, 1.0);
      const auto frames = static_cast<std::size_t>(std::floor(1 / every * (1 + 1e-12))) + 1;
      ASSERT_EQ(hits.size(), frames) << every << " " << dt;
      for (std::size_t k = 0; k < frames; k++) {
        const double due = static_cast<double>(k) * every;
        EXPECT_EQ(hits[k], frameTime(c, static_cast<std::int64_t>(k))) << every;
        EXPECT_NEAR(hits[k], due, 1e-14 * due) << every;
      }
      const double last = 1 - static_cast<double>(frames - 1) * every;  // between the last frame and the end
      // no tiny steps
      EXPECT_GE(shortest, 0.49 * std::min({dt, every, last > 1e-9 ? last : 1.0})) << every << " " << dt;
    }
}

TEST(Clock, FrameTimesDoNotDependOnTheEnd) {
  Clock until, beyond;
  for (double every : {0.05, 0.1, 0.2, 0.04, 1e-3})
    for (std::int64_t k = 1; k < 400; k++) {
      until.every = beyond.every = every;
      char text[32];
      std::snprintf(text, sizeof text, "%.10g", static_cast<double>(k) * every);
      until.end = std::strtod(text, nullptr);  // as read from a scene file
      beyond.end = 1000;
      ASSERT_EQ(frameTime(until, k), frameTime(beyond, k)) << text;
      ASSERT_EQ(frameTime(until, k), until.end) << text;
    }
}

TEST(Clock, MissedFramesDoNotStopIt) {
  Clock c;
  c.end = 1;
  c.every = 0.25;
  c.time = 0.6;  // frame 0 is still due
  EXPECT_EQ(timeAfter(c, clip(c, 0.5)), 0.75);
}

TEST(Clock, EndsWithoutFrames) {
  Clock c;
  c.end = 0.1;
  int n = 0;
  for (; c.time < c.end && n < 100; n++) c.time = timeAfter(c, clip(c, 0.03));
  EXPECT_EQ(c.time, 0.1);
  EXPECT_EQ(n, 4);
}

TEST(Clock, StepsBetweenFramesAreEqual) {
  Clock c;
  c.end = 1;
  c.every = 0.04;
  c.dt = 9e-4;  // 44.4 steps per frame
  int steps = 0;
  for (; c.time < c.end && steps < 10000; steps++) {
    c.stepDt = nextStep(c);
    EXPECT_NEAR(c.stepDt, 0.04 / 45, 1e-15);
    c.time = timeAfter(c, c.stepDt);
    while (frameDue(c)) c.frame++;
  }
  EXPECT_EQ(steps, 25 * 45);
  EXPECT_EQ(c.time, 1);
}

TEST(Clock, FixedStepIsKeptBetweenFrames) {
  Clock c;
  c.end = 1e9;
  c.dt = 1.83e-4;
  for (int n = 0; n < 100000; n++) {
    c.stepDt = nextStep(c);
    ASSERT_NEAR(c.stepDt, c.dt, 1e-9 * c.dt);
    c.time = timeAfter(c, c.stepDt);
  }
}

TEST(Clock, OscillatingLimitChangesNoStep) {
  Clock c;
  c.end = 1;
  c.every = 0.04;
  int changes = 0;
  for (int n = 0; c.time < c.end && n < 10000; n++) {
    c.dt = 9e-4 * (1 + 0.007 * std::sin(0.05 * n));
    const double dt = nextStep(c);
    EXPECT_LE(dt, c.dt * (1 + 1e-9));
    EXPECT_GE(dt, 0.95 * c.dt * (1 - 1 / 45.0));
    changes += std::abs(dt - c.stepDt) > 1e-9 * dt;
    c.stepDt = dt;
    c.time = timeAfter(c, dt);
    while (frameDue(c)) c.frame++;
  }
  EXPECT_LE(changes, 2);  // one of them is the first step
  EXPECT_EQ(c.time, 1);
  c.dt = 0;
  EXPECT_EQ(nextStep(c), 0);
}

TEST(Clock, FollowsALimitThatFallsAndRises) {
  Clock c;
  c.end = 1e9;
  c.dt = c.stepDt = 1;
  EXPECT_NEAR(nextStep(c), 1, 1e-6);
  c.dt = 0.5;
  c.stepDt = nextStep(c);
  EXPECT_NEAR(c.stepDt, 0.4925, 1e-6);
  c.dt = 0.515;
  EXPECT_NEAR(nextStep(c), 0.4925, 1e-6);
  c.dt = 0.6;
  EXPECT_NEAR(nextStep(c), 0.591, 1e-6);
}

TEST(StepLimits, MatchTheFormulasOfALiquid) {
  Scene s = oneMaterial();
  s.materials[0].surfaceTension = 0.07;
  s.materials[0].conductivity = {3, 3};
  Modules m;
  m.fluid = m.heat = true;
  const StepLimits l = materialLimits(s, m, liquidMaterials(s));
  const double h = 0.02;
  EXPECT_DOUBLE_EQ(l[Limit::Sound], 0.4 * h / 20);
  EXPECT_DOUBLE_EQ(l[Limit::Viscous], 0.8 * stableViscousStep(s.numerics) * h * h * 1000 / 2);
  EXPECT_NEAR(l[Limit::Tension], 0.25 * std::sqrt(1000 * h * h * h / (2 * std::numbers::pi * 0.07)), 1e-12);
  EXPECT_DOUBLE_EQ(l[Limit::Heat], 0.8 * stableHeatStep(s.numerics) * h * h / (3.0 / (1000.0 * 1000.0)));
  EXPECT_EQ(l[Limit::Elastic], never);
  EXPECT_EQ(l[Limit::Contact], never);
  EXPECT_EQ(l.smallest(), Limit::Sound);
}

TEST(StepLimits, MaterialsWithoutParticlesDoNotCount) {
  Scene s = oneMaterial();
  Modules m;
  m.fluid = true;
  const double alone = materialLimits(s, m, liquidMaterials(s)).value[0];
  s.materials.push_back(s.materials[0]);
  s.materials[1].soundSpeed = 2000;
  EXPECT_EQ(materialLimits(s, m, liquidMaterials(s)).value[0], alone);
  s.emitters.emplace_back();
  s.emitters[0].material = 1;
  EXPECT_DOUBLE_EQ(materialLimits(s, m, liquidMaterials(s)).value[0], alone / 100);
}

TEST(StepLimits, HeatFollowsTheBetterConductor) {
  Scene s = oneMaterial();
  s.materials[0].conductivity = {1, 1};
  Modules m;
  m.heat = true;
  const auto heat = [&] { return materialLimits(s, m, liquidMaterials(s))[Limit::Heat]; };
  const double alone = heat();
  s.materials.push_back(s.materials[0]);
  s.materials[1].conductivity = {1e6, 1e6};
  s.materials[1].heatCapacity = {1e12, 1e12};  // so that heat does not set the limit
  s.bodies.emplace_back();
  s.bodies[1].material = 1;
  EXPECT_NEAR(heat(), alone / 2, 1e-5 * alone);
}

TEST(StepLimits, ViscosityFollowsTheMeanOfTwoMaterials) {
  Scene s = oneMaterial();  // 2 Pa s
  s.materials[0].density = 10;
  Modules m;
  m.fluid = true;
  const auto viscous = [&] { return materialLimits(s, m, liquidMaterials(s))[Limit::Viscous]; };
  const double alone = viscous();
  s.materials.push_back(s.materials[0]);
  s.materials[1].density = 1e9;  // so that it does not set the limit itself
  s.materials[1].viscosity = {200, 200};
  s.bodies.emplace_back();
  s.bodies[1].material = 1;
  EXPECT_EQ(viscous(), alone);      // harmonic mean
  s.materials[0].young = {1e5, 0};  // a light solid that the liquid drags along, whatever its own viscosity
  EXPECT_NEAR(viscous(), alone * 2 / 200, 1e-12);
  s.materials[1].viscosity = {1, 1};
  EXPECT_NEAR(viscous(), alone * 2, 1e-12);
  s.materials[0].young = {0, 0};
  s.bodies.pop_back();
  s.numerics.viscosity = ViscosityForm::Laplacian;
  const double printed = viscous();
  s.bodies.emplace_back();
  s.bodies[1].material = 1;
  s.materials[1].viscosity = {0, 0};
  s.materials[1].viscosityTable = {{300, 1}, {400, 200}};
  EXPECT_NEAR(viscous(), printed / 50.5, 1e-9 * printed);  // arithmetic mean
}

TEST(StepLimits, SoundFollowsCompressionWithTait) {
  World w;
  w.scene = oneMaterial();
  w.modules.fluid = true;
  Continuum& p = w.particles;
  for (AnyColumn* c : p.columns) p.activate(*c);
  p.resize(3, 0);
  for (std::size_t i = 0; i < 3; i++)
    p.phase[i] = Liquid, p.liquid[i] = 1, p.relativeDensity[i] = 1 + 0.5f * static_cast<float>(i);
  EXPECT_EQ(soundStiffening(w.scene, w.modules, w.particles), 1);
  w.scene.numerics.eos = EquationOfState::Tait;
  EXPECT_DOUBLE_EQ(soundStiffening(w.scene, w.modules, w.particles), 8);
  p.phase[2] = Solid, p.liquid[2] = 0;
  EXPECT_DOUBLE_EQ(soundStiffening(w.scene, w.modules, w.particles), 3.375);
  p.relativeDensity[1] = 0.5f;
  EXPECT_EQ(soundStiffening(w.scene, w.modules, w.particles), 1);
}

TEST(StepLimits, ImplicitViscosityHasNoLimit) {
  Scene s = oneMaterial();
  s.materials[0].viscosity = {1e5, 1e5};
  Modules m;
  m.fluid = true;
  EXPECT_LT(materialLimits(s, m, liquidMaterials(s))[Limit::Viscous], never);
  m.implicitViscosity = true;
  EXPECT_EQ(materialLimits(s, m, liquidMaterials(s))[Limit::Viscous], never);
  s.materials[0].artificialViscosity = 0.1;  // stays explicit
  EXPECT_LT(materialLimits(s, m, liquidMaterials(s))[Limit::Viscous], never);
}

TEST(StepLimits, UseTheRatesOfParticles) {
  World w;
  w.scene = oneMaterial();
  w.scene.materials[0].viscosityTable = {{300, 10}, {400, 50}, {500, 1}};  // not monotone
  w.grid.support = 0.02;
  Continuum& p = w.particles;
  for (AnyColumn* c : {static_cast<AnyColumn*>(&p.velocity), static_cast<AnyColumn*>(&p.acceleration),
                       static_cast<AnyColumn*>(&p.material), static_cast<AnyColumn*>(&p.phase),
                       static_cast<AnyColumn*>(&p.temperature)})
    p.activate(*c);
  EXPECT_EQ(particleLimits(w, largestRates(w.particles), 0.04).smallest(), Limit::Sound);  // no limit at all
  EXPECT_EQ(particleLimits(w, largestRates(w.particles), 0.04).value[0], never);
  p.resize(2, 0);
  p.velocity[1] = {3, 0, 4};
  p.acceleration[0] = {0, 0, 8};
  p.temperature[0] = 350;
  p.temperature[1] = 450;
  p.phase[0] = p.phase[1] = Liquid;
  StepLimits l = particleLimits(w, largestRates(w.particles), 0.04);
  EXPECT_DOUBLE_EQ(l[Limit::Speed], 0.25 * 0.02 / 5);
  EXPECT_DOUBLE_EQ(l[Limit::Acceleration], 0.25 * std::sqrt(0.02 / 8));
  // 350 K is half way between 10 and 50 Pa s
  EXPECT_DOUBLE_EQ(l[Limit::Viscous], 0.8 * 0.04 * 0.02 * 0.02 * 1000 / std::sqrt(500));
}

}  // namespace thaw::test
