// SPDX-License-Identifier: Apache-2.0
// The stability monitor: its step factor over failures and snapshots, and the particle that it names.
#include "core/simulation/monitor/monitor.hpp"

#include <gtest/gtest.h>

#include "core/halo/serial.hpp"
#include "core/simulation/monitor/failing_particle.hpp"
#include "core/simulation/monitor/snapshot.hpp"

namespace thaw {
namespace {

TEST(Watch, FailureHalvesTheStepAndItGrowsBack) {
  World w;
  w.clock.dt = 0.4;
  w.clock.end = 1000;
  acceptState(w.monitor, w.clock, {});
  EXPECT_EQ(w.monitor.fullStep, 0.4);
  EXPECT_EQ(nextFactor(w.monitor), 1);
  MonitorState failed = w.monitor;
  halveStep(w.monitor, w.clock, w.scene, failed, 0);
  EXPECT_EQ(w.clock.dt, 0.2);
  EXPECT_EQ(w.monitor.factor, 0.5);
  EXPECT_EQ(w.monitor.failures, 1);
  failed = w.monitor;
  w.clock.dt = 0.4;  // rollback
  w.monitor = {};
  halveStep(w.monitor, w.clock, w.scene, failed, 5);
  EXPECT_EQ(w.clock.dt, 0.1);
  EXPECT_EQ(w.monitor.failures, 2);
  EXPECT_EQ(w.monitor.requiredSnapshots, 4);
  EXPECT_EQ(w.monitor.passed, 5 + 0.4 * static_cast<double>(w.scene.numerics.retryEvery));
  w.clock.time = w.monitor.passed;
  for (int good = 0; good < 3; good++) acceptState(w.monitor, w.clock, {});
  EXPECT_EQ(w.monitor.failures, 2);
  EXPECT_EQ(nextFactor(w.monitor), 0.25) << "not yet";
  acceptState(w.monitor, w.clock, {});
  EXPECT_EQ(w.monitor.backoff, 1);
  EXPECT_EQ(w.monitor.failures, 1) << "one retry fewer counts";
  for (int step = 0; step < 7; step++) {
    const double next = nextFactor(w.monitor);
    EXPECT_LE(next, 1.1 * w.monitor.factor);
    w.monitor.factor = next;
  }
  w.monitor.factor = nextFactor(w.monitor);
  EXPECT_EQ(w.monitor.factor, 0.5) << "eight steps of a tenth";
  for (int good = 0; good < 100; good++) acceptState(w.monitor, w.clock, {});
  EXPECT_EQ(w.monitor.backoff, 0);
  EXPECT_EQ(w.monitor.failures, 0);
  EXPECT_EQ(w.monitor.requiredSnapshots, 1) << "all failures are forgiven";
}

// Snapshots come arbitrarily close to a failure that no step prevents.
TEST(Watch, SnapshotsBeforeAFailureDoNotForgiveIt) {
  World w;
  MonitorLimits b;
  w.clock.dt = 1;
  w.clock.end = 1000;
  w.scene.numerics.retryEvery = 10;
  acceptState(w.monitor, w.clock, {});
  constexpr double failsAt = 7;
  std::int64_t tries = 0;
  for (; mayRetry(w.scene.numerics, w.monitor, w.clock, b) && tries < 100; tries++) {
    const double before = w.clock.time;
    halveStep(w.monitor, w.clock, w.scene, w.monitor, failsAt);
    for (int good = 0; good < 1000; good++) {  // all the way to the failure
      w.clock.time = before + (failsAt - before) * good / 1000;
      acceptState(w.monitor, w.clock, {});
    }
  }
  EXPECT_EQ(tries, w.scene.numerics.retries);
  EXPECT_EQ(w.monitor.backoff, w.scene.numerics.retries);
  w.clock.time = failsAt + 10;  // past it by the time of retry_every full steps
  for (int good = 0; good < 64; good++) acceptState(w.monitor, w.clock, {});
  EXPECT_TRUE(mayRetry(w.scene.numerics, w.monitor, w.clock, b));
}

TEST(Watch, NoRetryTakesAStepBelowTheLimit) {
  World w;
  MonitorLimits b;
  b.step = 0.2;
  w.clock.dt = 1;
  acceptState(w.monitor, w.clock, {});
  EXPECT_TRUE(mayRetry(w.scene.numerics, w.monitor, w.clock, b));
  halveStep(w.monitor, w.clock, w.scene, w.monitor, 0);
  EXPECT_TRUE(mayRetry(w.scene.numerics, w.monitor, w.clock, b)) << "0.25 s";
  halveStep(w.monitor, w.clock, w.scene, w.monitor, 0);
  EXPECT_EQ(w.clock.dt, 0.25);
  EXPECT_FALSE(mayRetry(w.scene.numerics, w.monitor, w.clock, b)) << "0.125 s";
  EXPECT_TRUE(retryTooShort(w.monitor, w.clock, b));
}

TEST(Watch, HalvesStepsCutByFrames) {
  World w;
  w.clock.dt = 1;
  w.clock.every = 0.3;
  acceptState(w.monitor, w.clock, {});
  halveStep(w.monitor, w.clock, w.scene, w.monitor, 0);
  EXPECT_EQ(w.clock.dt, 0.125) << "half of the first power of two below 0.3";
}

// An infinite step has no half. The number of halvings must stay below 63, since the message has 1 <<
// halvings.
TEST(Watch, HalvesTheFrameIntervalWithoutAStepLimit) {
  World w;
  w.clock.dt = never;
  w.clock.every = 0.3;
  acceptState(w.monitor, w.clock, {});
  halveStep(w.monitor, w.clock, w.scene, w.monitor, 0);
  EXPECT_EQ(w.clock.dt, 0.15);
  EXPECT_EQ(w.monitor.backoff, 1);
  const MonitorState failed = w.monitor;
  w.clock.dt = never;
  w.monitor = {};
  halveStep(w.monitor, w.clock, w.scene, failed, 0);
  EXPECT_EQ(w.clock.dt, 0.075);
  MonitorState often;
  often.backoff = 100;
  halveStep(w.monitor, w.clock, w.scene, often, 0);
  EXPECT_LT(w.monitor.backoff, 63) << "the message has 1 << halvings";
}

TEST(Watch, IgnoresALongHeatLimit) {
  Scene s;
  s.spacing = 0.01;
  s.domain.gravity = {};
  s.materials.emplace_back();
  s.bodies.emplace_back();
  s.bodies[0].velocity = {1, 0, 0};
  StepLimits l;
  l[Limit::Heat] = 300;
  const double step = monitorLimits(s, {}, {}, l).step,
               ofSpeed = supportsPerStep * s.numerics.support * 0.01 / 1;
  EXPECT_DOUBLE_EQ(step, s.numerics.watchStep * ofSpeed);
  l[Limit::Sound] = 1e-3;
  EXPECT_DOUBLE_EQ(monitorLimits(s, {}, {}, l).step, s.numerics.watchStep * 1e-3);
}

TEST(Watch, FindsFailuresOfReducedValues) {
  World w;
  w.grid.support = 0.1;
  MonitorLimits b;
  b.speed = 10, b.relativeDensity = 2, b.step = 1e-6;
  StepLimits l;
  l[Limit::Speed] = supportsPerStep * 0.1 / 9.9;
  EXPECT_EQ(failureOf(w, b, l, 1.9), Failure::None);
  EXPECT_EQ(failureOf(w, b, l, 2.1), Failure::Density);
  l[Limit::Elastic] = 0.9e-6;
  EXPECT_EQ(failureOf(w, b, l, 1), Failure::Step);
  l[Limit::Elastic] = 1.1e-6;
  EXPECT_EQ(failureOf(w, b, l, 1), Failure::None);
  w.monitor.factor = 0.5, w.monitor.backoff = 1;
  EXPECT_EQ(failureOf(w, b, l, 1), Failure::Step) << "half of the limit is reported";
  w.monitor = {};
  w.scene.numerics.fixedStep = 1e-3;
  EXPECT_EQ(failureOf(w, b, l, 1), Failure::None) << "a fixed step ignores the limits";
  l[Limit::Speed] = supportsPerStep * 0.1 / 10.1;
  EXPECT_EQ(failureOf(w, b, l, 1), Failure::Speed);
  b.speed = never;
  EXPECT_EQ(failureOf(w, b, l, 1), Failure::None);
}

TEST(Watch, FindsUnexplainedEnergySinceTheLastSnapshot) {
  World w;
  SerialReducer all;
  MonitorLimits b;
  b.expected = 2, b.energy = 0.5;
  LedgerReport budget;
  budget.now.mass = 1;       // 2 J at the expected speed
  budget.energyScale = 100;  // over the whole run
  w.monitor.residual = 5;
  budget.energyResidual = 5.9;
  EXPECT_EQ(checkEnergyBudget(w, b, budget, all), Failure::None);
  budget.energyResidual = 6.1;
  EXPECT_EQ(checkEnergyBudget(w, b, budget, all), Failure::Energy);
  w.monitor.scale = 3;
  EXPECT_EQ(checkEnergyBudget(w, b, budget, all), Failure::None);
  budget.energyResidual = -never + never;
  EXPECT_EQ(checkEnergyBudget(w, b, budget, all), Failure::Energy) << "not a number";
}

TEST(Watch, FindsSlowlyGrowingUnexplainedEnergy) {
  World w;
  SerialReducer all;
  MonitorLimits b;
  b.expected = 20, b.energy = 0.5;
  LedgerReport budget;
  budget.now.mass = 1;  // 200 J at the expected speed, 2 J at a tenth of it
  budget.energyScale = 10;
  for (int good = 0; good < 10; good++) {  // half a joule each time, which is little of 200 J
    budget.energyResidual = 0.5 * good;
    EXPECT_EQ(checkEnergyBudget(w, b, budget, all), Failure::None) << good;
    acceptState(w.monitor, w.clock, budget);
  }
  EXPECT_EQ(w.monitor.largest, 10);
  budget.energyScale = 1;  // the largest earlier scale counts
  EXPECT_EQ(checkEnergyBudget(w, b, budget, all), Failure::None);
  budget.energyResidual = 5.1;
  EXPECT_EQ(checkEnergyBudget(w, b, budget, all), Failure::Growth);
  budget.energyScale = 11;
  EXPECT_EQ(checkEnergyBudget(w, b, budget, all), Failure::None);
  budget.energyResidual = 5.6;
  w.monitor.residual = 5.7;
  EXPECT_EQ(checkEnergyBudget(w, b, budget, all), Failure::None) << "it has decreased";
  w.monitor.residual = 5.5;
  b.energy = never;
  EXPECT_EQ(checkEnergyBudget(w, b, budget, all), Failure::None) << "not watched";
  b.energy = 0.5;
  budget.energyResidual = -100;
  EXPECT_EQ(checkEnergyBudget(w, b, budget, all), Failure::None) << "lost";
}

TEST(Watch, NamesTheLowestIdAmongEquals) {
  World w;
  Continuum& p = w.particles;
  for (AnyColumn* c : p.columns)
    if (c != &p.solidIndex) p.activate(*c);
  p.resize(3, 0);
  const std::uint64_t ids[3] = {std::uint64_t(9) << 40 | 3, std::uint64_t(2) << 40 | 8,
                                std::uint64_t(2) << 40 | 7};
  for (std::size_t i = 0; i < 3; i++)
    p.id[i] = ids[i], p.mass[i] = 1, p.velocity[i] = {0, i == 0 ? 2.0 : 3.0, 0};
  SerialReducer all;
  const FailingParticle s = findFailingParticle(w, Failure::Speed, Limit::Speed, all);
  EXPECT_TRUE(s.here);
  EXPECT_EQ(s.row, 2u);
  EXPECT_EQ(s.value, 3);
  p.force[0] = {0, 0, never - never};
  EXPECT_EQ(findFailingParticle(w, Failure::NotFinite, Limit::Speed, all).row, 0u);
}

TEST(Watch, RestoresASnapshot) {
  World w;
  WorldSnapshot kept;
  StepTools tools;
  Continuum& p = w.particles;
  for (AnyColumn* c : {static_cast<AnyColumn*>(&p.id), static_cast<AnyColumn*>(&p.position),
                       static_cast<AnyColumn*>(&p.relativeDensity)})
    p.activate(*c);
  p.resize(2, 3);
  p.id[0] = 11, p.id[1] = 12;
  p.position[1] = {1, 2, 3};
  w.clock.step = 7;
  w.counters.melted = 4;
  takeSnapshot(w, kept);
  for (std::size_t c = 0; c < p.columns.size(); c++)
    EXPECT_EQ(kept.particles.columns[c].there, p.columns[c] == &p.id || p.columns[c] == &p.position)
        << p.columns[c]->name << "; the relative density is recomputed";
  p.position[1] = {};
  w.clock.step = 9;
  emptyWorld(w, tools);
  EXPECT_EQ(p.size(), 0u);
  EXPECT_TRUE(restoreSnapshot(kept, w).empty());
  EXPECT_EQ(p.owned, 2u);
  EXPECT_EQ(p.ghosts, 0u);
  EXPECT_EQ(p.id[1], 12u);
  EXPECT_EQ(p.position[1].z, 3);
  EXPECT_EQ(w.clock.step, 7);
  EXPECT_EQ(w.counters.melted, 4);
}

}  // namespace
}  // namespace thaw
