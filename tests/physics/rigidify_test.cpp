// SPDX-License-Identifier: Apache-2.0
// Parts of elastic solids move as rigid pieces while they do not deform (core/rigid/rigidify/). Bodies in
// free fall take long steps, bounces and bending stay those of the elastic body, and the ledger closes.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/simulation.hpp"

namespace thaw {
namespace {

using namespace test;

std::size_t rigidCount(const Continuum& p) {
  std::size_t n = 0;
  for (std::size_t i = 0; i < p.owned; i++) n += isRigid(p, i);
  return n;
}

double centreHeight(const Continuum& p) {
  double sum = 0, mass = 0;
  for (std::size_t i = 0; i < p.owned; i++) sum += p.mass[i] * p.position[i].z, mass += p.mass[i];
  return sum / mass;
}

/// A cube of rubber that falls on a floor.
Scene fallingCube(double young) {
  Scene s = emptyScene(0.1, {-2, -2, -0.5}, {2, 2, 4});
  s.domain.gravity = {0, 0, -9.81};
  addFloor(s);
  s.materials.emplace_back();
  s.materials[0].name = "rubber";
  s.materials[0].law.name = "neo-hookean";
  s.materials[0].young = {young, young};
  s.materials[0].density = 1000;
  s.materials[0].damping = 20;
  addBox(s, {-0.3, -0.3, 0.6}, {0.3, 0.3, 1.2});
  s.numerics.rigidify = 0.2;
  return s;
}

TEST(Rigidify, BodyInFreeFallIsRigidAndTakesLongSteps) {
  Scene s = fallingCube(1e9);
  s.end = 0.2;
  Simulation x(s);
  ASSERT_TRUE(x.run());
  EXPECT_EQ(rigidCount(x.particles()), x.particles().owned);
  EXPECT_LT(x.w.clock.step, 150);  // elastic waves allow 3e-5 s
  EXPECT_NEAR(centreHeight(x.particles()), 0.9 - 0.5 * 9.81 * 0.04, 1e-9);
  EXPECT_NEAR(x.ledgerReport().energyResidual, 0, 1e-9 * x.ledgerReport().energyScale);
}

TEST(Rigidify, BounceIsThatOfTheElasticBody) {
  double top[2] = {};
  std::int64_t steps[2] = {};
  for (const bool rigid : {false, true}) {
    Scene s = fallingCube(3e6);
    s.end = 0.9;
    if (!rigid) s.numerics.rigidify = 0;
    Simulation x(s);
    double highest = 0;
    while (x.w.clock.time < s.end) {
      ASSERT_TRUE(x.step());
      if (x.w.clock.time > 0.45) highest = std::max(highest, centreHeight(x.particles()));
    }
    top[rigid] = highest - 0.35;
    steps[rigid] = x.w.clock.step;
    const LedgerReport report = x.ledgerReport();
    EXPECT_LT(std::abs(report.energyResidual), 2e-3 * report.energyScale);
    EXPECT_LT(length(report.momentumResidual), 1e-9 * report.now.mass);
  }
  EXPECT_GT(top[0], 0.1);
  EXPECT_NEAR(top[1], top[0], 0.03 * top[0]);
  EXPECT_LT(steps[1], 0.9 * static_cast<double>(steps[0]));
}

TEST(Rigidify, TurningBodyKeepsMomentumAsItGetsRigidAndElastic) {
  Scene s = emptyScene(0.1, {-2, -2, -2}, {2, 2, 2});
  s.materials.emplace_back();
  s.materials[0].name = "rubber";
  s.materials[0].law.name = "neo-hookean";
  s.materials[0].young = {1e6, 1e6};
  s.materials[0].damping = 200;
  addBox(s, {-0.8, -0.2, -0.2}, {0.8, 0.2, 0.2}).spin = {0.5, 1, 3};
  s.numerics.rigidify = 0.05;
  s.end = 1;
  Simulation x(s);
  const LedgerReport start = x.ledgerReport();
  bool elastic = false, rigid = false;
  while (x.w.clock.time < s.end) {
    ASSERT_TRUE(x.step());
    const std::size_t n = rigidCount(x.particles());
    elastic = elastic || (n == 0 && x.w.clock.step > 10);
    rigid = rigid || (elastic && n == x.particles().owned);
  }
  EXPECT_TRUE(elastic) << "centrifugal forces stretch it at the start";
  EXPECT_TRUE(rigid);
  const LedgerReport end = x.ledgerReport();
  EXPECT_LT(length(end.now.angularMomentum - start.now.angularMomentum),
            1e-9 * length(start.now.angularMomentum));
  EXPECT_GT(end.now.elastic, 0);
  EXPECT_LT(std::abs(end.energyResidual), 1e-4 * end.energyScale);
}

TEST(Rigidify, BodiesThatMeetInTheAirWake) {
  Scene s = fallingCube(1e7);
  s.domain.gravity = {};
  s.obstacles.clear();
  s.bodies[0].velocity = {0, 0, 1};
  addBox(s, {-0.3, -0.3, 1.6}, {0.3, 0.3, 2.2});
  s.materials[0].restitution = 1;
  s.end = 0.8;
  Simulation x(s);
  std::size_t fewest = x.particles().owned;
  while (x.w.clock.time < s.end) {
    ASSERT_TRUE(x.step());
    fewest = std::min(fewest, x.w.clock.time > 0.2 ? rigidCount(x.particles()) : fewest);
  }
  EXPECT_LT(fewest, x.particles().owned / 2);
  double up[2] = {};
  for (std::size_t i = 0; i < x.particles().owned; i++)
    up[x.particles().body[i]] += x.particles().velocity[i].z / 216;
  EXPECT_NEAR(up[0] + up[1], 1, 1e-9);
  EXPECT_LT(up[0], 0.3);
  const LedgerReport report = x.ledgerReport();
  EXPECT_LT(std::abs(report.energyResidual), 2e-3 * report.energyScale);
}

TEST(Rigidify, LiquidThatHitsABodyWakesIt) {
  Scene s = fallingCube(1e6);
  s.domain.gravity = {};
  s.obstacles.clear();
  s.materials.emplace_back();
  s.materials[1].name = "water";
  s.materials[1].soundSpeed = 50;
  Body& drop = addBox(s, {-0.2, -0.2, 1.5}, {0.2, 0.2, 1.8});
  drop.material = 1;
  drop.velocity = {0, 0, -4};
  s.end = 0.15;
  Simulation x(s);
  std::size_t most = 0, fewest = 216;
  while (x.w.clock.time < s.end) {
    ASSERT_TRUE(x.step());
    const std::size_t n = rigidCount(x.particles());
    most = std::max(most, n);
    if (most == 216) fewest = std::min(fewest, n);
  }
  EXPECT_EQ(most, 216u) << "the cube is rigid until the drop hits it";
  EXPECT_LT(fewest, 100u);
  EXPECT_LT(length(x.ledgerReport().momentumResidual), 1e-9 * x.ledgerReport().now.mass);
}

TEST(Rigidify, ColdTopOfAMeltingBlockIsRigid) {
  double liquid[2] = {}, height[2] = {};
  for (const bool rigid : {false, true}) {
    Scene s = emptyScene(0.02, {-0.3, -0.3, -0.1}, {0.3, 0.3, 0.4});
    s.domain.gravity = {0, 0, -9.81};
    addFloor(s).temperature = 520;
    s.materials.push_back(wax());
    s.materials[0].name = "wax";
    s.materials[0].soundSpeed = 20;
    addBox(s, {-0.08, -0.08, 0.01}, {0.08, 0.08, 0.25}).temperature = 293;
    s.numerics.rigidify = rigid ? 0.5 : 0;
    s.end = 0.5;
    Simulation x(s);
    std::size_t most = 0;
    while (x.w.clock.time < s.end) {
      ASSERT_TRUE(x.step());
      if (rigid) most = std::max(most, rigidCount(x.particles()));
    }
    if (rigid) { EXPECT_GT(most, x.particles().owned / 2); }
    const Continuum& p = x.particles();
    for (std::size_t i = 0; i < p.owned; i++) liquid[rigid] += static_cast<double>(p.liquid[i]);
    height[rigid] = centreHeight(p);
    const LedgerReport report = x.ledgerReport();
    EXPECT_LT(std::abs(report.energyResidual), 5e-3 * report.energyScale);
  }
  EXPECT_GT(liquid[0], 10);
  EXPECT_NEAR(liquid[1], liquid[0], 0.02 * liquid[0]);
  EXPECT_NEAR(height[1], height[0], 0.005 * height[0]);
}

}  // namespace
}  // namespace thaw
