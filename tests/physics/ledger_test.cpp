// SPDX-License-Identifier: Apache-2.0
// The ledger of closed and open systems.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/simulation.hpp"

namespace thaw::test {
namespace {

constexpr double dx = 0.05;

Scene freeBlock(const char* law) {
  Scene s;
  s.spacing = dx;
  s.domain.gravity = {};
  s.output.every = 0;
  s.numerics.precision = Precision::Double;
  s.materials.emplace_back();
  s.materials[0].young = {1e5, 1e5};
  s.materials[0].law.name = law;
  Body& b = addBox(s, {-0.2, -0.1, -0.1}, {0.2, 0.1, 0.1});
  b.spin = {0, 3, 4};
  b.velocity = {0.5, 0.2, 0.1};
  s.end = 0.3;
  return s;
}

}  // namespace

TEST(Ledger, FreeSpinningSolidKeepsMomentumAngularMomentumAndEnergy) {
  for (const char* const law : {"green", "neo-hookean"}) {
    Simulation run(freeBlock(law));
    EXPECT_TRUE(run.run());
    const LedgerReport r = run.ledgerReport();
    const double scale = r.initial.mass * 1.0;
    EXPECT_EQ(r.massResidual, 0);
    EXPECT_LT(length(r.momentumResidual), 1e-12 * scale);
    EXPECT_LT(length(r.now.angularMomentum - r.initial.angularMomentum), 1e-10 * scale);
    EXPECT_LT(std::abs(r.energyResidual), 5e-3 * r.initial.kinetic);
    EXPECT_GT(r.now.elastic, 0);
  }
}

TEST(Ledger, PeriodicLiquidConservesMomentumAndRecordsDissipation) {
  Scene s = columnScene(dx, 0, 6 * dx);
  s.domain.side[2] = {Side::Periodic, Side::Periodic};
  s.numerics.precision = Precision::Double;
  s.materials[0].soundSpeed = 5;
  s.materials[0].viscosity = {20, 20};
  addBox(s, {0, 0, 0}, {6 * dx, 6 * dx, 6 * dx});
  s.end = 0.2;
  Simulation run(s);
  Continuum& p = run.particles();
  for (std::size_t i = 0; i < p.owned; i++)
    p.velocity[i] = {0.3 + 0.4 * std::sin(2 * std::numbers::pi * p.position[i].z / (6 * dx)), 0.2, 0.1};
  run.w.ledger.initial = run.ledgerReport().now;
  EXPECT_TRUE(run.run());
  const LedgerReport r = run.ledgerReport();
  EXPECT_EQ(r.massResidual, 0);
  EXPECT_LT(length(r.momentumResidual), 1e-12 * r.initial.mass);
  EXPECT_GT(r.dissipated, 0.1 * r.initial.kinetic);
  EXPECT_LT(std::abs(r.energyResidual), 0.05 * r.dissipated);
}

TEST(Ledger, EmittersAndOpenSidesCountExactly) {
  Scene s;
  s.spacing = dx;
  s.domain.gravity = {0, 0, -10};
  s.domain.min = {-0.5, -0.5, -0.4};
  s.domain.max = {0.5, 0.5, 0.5};
  s.output.every = 0;
  s.materials.emplace_back();
  s.materials[0].soundSpeed = 20;
  s.materials[0].viscosity = {1, 1};
  s.emitters.emplace_back();
  s.emitters[0].radius = 0.1;
  s.emitters[0].centre = {0, 0, 0.3};
  s.emitters[0].speed = 2;
  s.end = 0.6;
  Simulation run(s);
  EXPECT_TRUE(run.run());
  const LedgerReport r = run.ledgerReport();
  EXPECT_GT(run.w.counters.emitted, 100);
  EXPECT_GT(run.w.counters.left, 20);
  const double m = 1000 * dx * dx * dx;
  EXPECT_EQ(r.massResidual, 0);
  EXPECT_NEAR(r.left.mass, static_cast<double>(run.w.counters.left) * m, 1e-12);
  EXPECT_NEAR(r.initial.mass + r.entered.mass - r.left.mass, r.now.mass, 1e-12);
  EXPECT_LT(length(r.momentumResidual), 1e-5 * length(r.left.momentum));
}

TEST(Ledger, ClosesWhereParticlesFallThroughAnOpenSide) {
  Scene s = emptyScene(dx, {-0.5, -0.5, -0.4}, {0.5, 0.5, 0.5});
  s.domain.gravity = {0, 0, -10};
  s.materials.emplace_back();
  addBox(s, {0, 0, 0}, {2 * dx, dx, dx});  // solid: no force but its weight
  s.materials[0].young = {1e4, 1e4};
  s.end = 0.5;
  Simulation run(s);
  EXPECT_TRUE(run.run());
  const LedgerReport r = run.ledgerReport();
  EXPECT_EQ(run.w.counters.left, 2);
  EXPECT_LT(std::abs(r.energyResidual), 1e-9 * r.left.kinetic);
}

/// A drop with surface tension leaves through an open side, across a periodic side.
Scene leavingDrop(TensionForm tension) {
  Scene s = emptyScene(dx, {-0.5, -0.3, -0.3}, {0.5, 0.3, 0.3});
  s.domain.side[1] = {Side::Periodic, Side::Periodic};
  s.materials.emplace_back();
  s.materials[0].soundSpeed = 20;
  s.materials[0].viscosity = {1, 1};
  s.materials[0].surfaceTension = 72;
  s.numerics.tension = tension;
  s.bodies.emplace_back();
  s.bodies[0].name = "drop";
  s.bodies[0].shape.kind = ShapeKind::Sphere;
  s.bodies[0].shape.radius = 0.2;
  s.bodies[0].shape.move = {0.25, 0, 0};
  s.bodies[0].velocity = {1, 0.5, 0};
  s.end = 0.9;
  return s;
}

class LeavingDrop : public testing::TestWithParam<TensionForm> {};

// The neighbours of a leaving particle gain surface energy. The energy of the particle alone would leave a
// third of the total unexplained.
TEST_P(LeavingDrop, TakesItsSurfaceEnergyAlong) {
  Simulation run(leavingDrop(GetParam()));
  const double before = run.ledgerReport().now.potential;
  EXPECT_TRUE(run.run());
  const LedgerReport r = run.ledgerReport();
  EXPECT_GT(r.left.mass, 0.8 * r.initial.mass);
  EXPECT_LT(std::abs(r.energyResidual), 0.1 * std::abs(before)) << r.left.potential;
}

INSTANTIATE_TEST_SUITE_P(Ledger, LeavingDrop,
                         testing::Values(TensionForm::SurfaceEnergy, TensionForm::Pairwise));

// Particles that fall through a periodic side re-enter higher up. The ledger records that height.
TEST(Ledger, RecordsFallsThroughPeriodicSides) {
  Scene s = columnScene(dx, 0, 12 * dx);
  s.domain.side[2] = {Side::Periodic, Side::Periodic};
  s.domain.gravity = {1, 0, -10};
  s.materials[0].soundSpeed = 5;
  s.materials[0].viscosity = {20, 20};
  addBox(s, {0, 0, 2 * dx}, {6 * dx, 6 * dx, 6 * dx});
  s.end = 0.5;
  Simulation run(s);
  EXPECT_TRUE(run.run());
  const LedgerReport r = run.ledgerReport();
  EXPECT_GT(r.entered.potential, 2 * r.initial.mass * 10 * 12 * dx * 0.9);  // twice through the domain
  EXPECT_NEAR(r.now.kinetic, 0.5 * r.initial.mass * (1 + 100) * s.end * s.end, 1e-3 * r.now.kinetic);
  EXPECT_LT(std::abs(r.energyResidual), 1e-3 * r.now.kinetic);
}

// A slow emitter just above a floor: emitted liquid backs up, and the emitter pushes it like a piston. The
// ledger records its work.
TEST(Ledger, RecordsWorkOfAnEmitterAsAPiston) {
  Scene s = emptyScene(0.01, {-0.2, -0.2, -0.02}, {0.2, 0.2, 0.2});
  s.domain.gravity = {0, 0, -9.81};
  s.materials.emplace_back();
  s.materials[0].viscosity = {30, 30};
  s.materials[0].soundSpeed = 15;
  s.materials[0].surfaceTension = 0.5;
  s.emitters.emplace_back();
  s.emitters[0].radius = 0.03;
  s.emitters[0].centre = {0, 0, 0.015};
  s.emitters[0].speed = 0.2;
  addFloor(s);
  s.end = 0.5;
  Simulation run(s);
  EXPECT_TRUE(run.run());
  const LedgerReport r = run.ledgerReport();
  EXPECT_GT(run.w.counters.emitted, 250);
  EXPECT_EQ(run.w.counters.left, 0);
  EXPECT_LT(std::abs(r.energyResidual), 0.01 * r.energyScale);
  EXPECT_LT(length(r.momentumResidual), 1e-6 * length(r.gravityImpulse));
  double fastest = 0;
  for (std::size_t i = 0; i < run.particles().owned; i++)
    fastest = std::max(fastest, length(run.particles().velocity[i]));
  EXPECT_LT(fastest, 1);  // no particle is ejected
}

// A solid softens, sags and melts on a hot plate. The ledger records the energy that elasticity, pressure,
// tension, contacts and bonds lose to a changing liquid fraction.
TEST(Ledger, ClosesForAMeltingSolid) {
  Scene s = emptyScene(0.01, {-0.2, -0.2, -0.02}, {0.2, 0.2, 0.2});
  s.domain.gravity = {0, 0, -9.81};
  s.materials.push_back(wax());
  s.materials[0].soundSpeed = 26;
  s.materials[0].surfaceTension = 0.03;
  addBox(s, {-0.03, -0.03, 0.01}, {0.03, 0.03, 0.13}).temperature = 293;
  addFloor(s).temperature = 523;
  s.end = 0.6;
  Simulation run(s);
  EXPECT_TRUE(run.run());
  const LedgerReport r = run.ledgerReport();
  EXPECT_GT(run.w.counters.melted, 10);
  EXPECT_LT(std::abs(r.heatResidual), 1e-12 * r.heatIn);
  EXPECT_LT(std::abs(r.energyResidual), 0.005 * r.energyScale);
}

/// Freezes the liquids of two bodies that do not weld, whose nearest layers are `gap` spacings apart.
struct FrozenPair {
  double before, made;  ///< J, mechanical energy before, and its change in four steps
  double residual;      ///< J
};

FrozenPair freezePair(double gap) {
  Scene s;
  s.spacing = dx;
  s.domain.gravity = {};
  s.output.every = 0;
  s.numerics.precision = Precision::Double;
  s.numerics.overlap = OverlapRule::Keep;
  s.materials.push_back(wax());
  s.materials[0].soundSpeed = 1;
  for (int k = 0; k < 2; k++)
    addBox(s, {k * (gap + 3) * dx, 0, 0}, {(k * (gap + 3) + 4) * dx, 4 * dx, 4 * dx}).temperature = 350;
  s.numerics.maxStep = 1e-4;
  s.thermostats.emplace_back();  // in one step
  s.thermostats[0].start = 0.01;
  s.thermostats[0].temperature = 300;
  s.end = 1;
  Simulation run(s);
  while (run.w.counters.frozen == 0) EXPECT_TRUE(run.step());
  const LedgerReport before = run.ledgerReport();  // contacts push from the next evaluation on
  for (int k = 0; k < 4; k++) EXPECT_TRUE(run.step());
  const LedgerReport r = run.ledgerReport();
  EXPECT_EQ(run.w.counters.frozen, 128);
  const auto mechanical = [](const Balance& b) { return b.kinetic + b.elastic + b.potential; };
  return {mechanical(before.now), mechanical(r.now) - mechanical(before.now), std::abs(r.energyResidual)};
}

// Liquids of two bodies come closer than solids may. Where they freeze closer than half a spacing, their
// contacts push at once.
TEST(Ledger, RecordsContactsOfFreshlyFrozenParticles) {
  const FrozenPair f = freezePair(0.3);
  EXPECT_GT(f.made, 10 * f.before);
  EXPECT_LT(f.residual, 0.01 * f.made);
}

TEST(Ledger, FrozenParticlesRestCloseToAnotherBody) {
  const FrozenPair f = freezePair(0.8);
  EXPECT_LT(std::abs(f.made), 0.02 * f.before);
  EXPECT_LT(f.residual, 0.02 * f.before);
}

TEST(StepLimits, StretchedSolidNeedsSmallerSteps) {
  Scene s = freeBlock("green");
  s.materials[0].hourglass = 0.1;  // a small part of the modulus
  Simulation run(s);
  EXPECT_STREQ(run.w.clock.limitedBy, "elastic waves");
  const double atRest = run.w.clock.dt;
  EXPECT_NEAR(atRest, elasticStepLimit(run.w.scene), 1e-6 * atRest);
  for (std::size_t i = 0; i < run.particles().owned; i++) run.particles().position[i].x *= 1.5;
  EXPECT_TRUE(run.step());
  EXPECT_STREQ(run.w.clock.limitedBy, "elastic waves");
  // The modulus of Green strain is (3 * 1.5^2 - 1) / 2 = 2.875 times that at rest. The hourglass control's is
  // not.
  EXPECT_LT(run.w.clock.dt, atRest / 1.6);
  EXPECT_GT(run.w.clock.dt, atRest / 1.9);
}

}  // namespace thaw::test
