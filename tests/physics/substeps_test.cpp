// SPDX-License-Identifier: Apache-2.0
// Solids with substeps (core/simulation/solid_substeps.hpp): the same motion, and a closed ledger.
#include <gtest/gtest.h>

#include <cmath>

#include "core/solid/laws/plasticity.hpp"
#include "tests/support/simulation.hpp"

namespace thaw::test {
namespace {

Scene stiffBlock(int substeps) {
  Scene s;
  s.spacing = 0.05;
  s.domain.gravity = {};
  s.output.every = 0;
  s.end = 100;
  s.numerics.precision = Precision::Double;
  s.numerics.elasticSubsteps = substeps;
  s.materials.emplace_back();
  s.materials[0].young = {1e6, 1e6};
  s.materials[0].law.name = "corotated";
  addBox(s, {-0.2, -0.1, -0.1}, {0.2, 0.1, 0.1});
  return s;
}

/// Time (s) of the third return of an initially stretched bar to its length.
double thirdReturn(int substeps) {
  Simulation run(stiffBlock(substeps));
  Continuum& p = run.particles();
  for (std::size_t i = 0; i < p.owned; i++) p.velocity[i].x = 0.5 * std::sin(3.14159 * p.position[i].x / 0.4);
  double before = 0, at = 0;
  for (int found = 0; found < 3;) {
    EXPECT_TRUE(run.step());
    if (testing::Test::HasFailure()) return 0;
    double now = 0;
    for (std::size_t i = 0; i < p.owned; i++) now += p.velocity[i].x * p.position[i].x;
    if (before * now < 0) {
      found++;
      at = run.w.clock.time - run.w.clock.stepDt * now / (now - before);
    }
    before = now;
  }
  EXPECT_EQ(run.w.clock.substeps, substeps);
  return at;
}

}  // namespace

TEST(Substeps, FrequencyOfAFreeBarIsTheSame) {
  const double one = thirdReturn(1), eight = thirdReturn(8);
  EXPECT_NEAR(eight, one, 0.01 * one);
}

// With four substeps the impulses of the pressure feed elastic waves, and the dissipation turns negative.
TEST(Substeps, OfSolidsInIncompressibleLiquidGainNoEnergy) {
  Scene s = emptyScene(0.0262, {0, 0, 0}, {0.3, 0.3, 0.4});
  for (auto& side : s.domain.side) side = {Side::Wall, Side::Wall};
  s.domain.gravity = {0, 0, -9.81};
  s.numerics.solver = PressureSolver::Incompressible;
  s.numerics.overlap = OverlapRule::RemoveLater;
  s.materials.resize(2);
  s.materials[0].name = "liquid";
  s.materials[0].density = 2200;
  s.materials[0].viscosity = {0.6, 0.6};
  s.materials[1].name = "solid";
  s.materials[1].density = 4100;
  s.materials[1].young = {2e5, 0};
  s.materials[1].law.name = "corotated";
  addBox(s, {0.08, 0.08, 0.1}, {0.21, 0.18, 0.18}).material = 1;
  s.bodies[0].shape.rotate = {0.5, 0.3, 0};
  addBox(s, {0, 0, 0}, {0.3, 0.3, 0.14});
  s.end = 1.5;
  Simulation run(s);
  EXPECT_EQ(run.w.modules.mostSubsteps, 2);
  ASSERT_TRUE(run.run());
  const LedgerReport l = run.ledgerReport();
  EXPECT_LT(std::abs(l.energyResidual), 0.02 * l.energyScale);
}

TEST(Substeps, ConserveMomentumAndEnergyOverAThousandSteps) {
  Scene s = stiffBlock(8);
  s.bodies[0].spin = {0, 3, 4};
  s.bodies[0].velocity = {0.5, 0.2, 0.1};
  s.domain.min = {-5, -5, -5};
  s.domain.max = {5, 5, 5};
  Simulation run(s);
  for (int k = 0; k < 1000; k++) {
    ASSERT_TRUE(run.step());
    if (k % 100 != 99) continue;
    const LedgerReport r = run.ledgerReport();
    EXPECT_LT(length(r.momentumResidual), 1e-11 * r.initial.mass);
    EXPECT_LT(length(r.now.angularMomentum - r.initial.angularMomentum), 1e-9 * r.initial.mass);
    EXPECT_LT(std::abs(r.energyResidual), 5e-3 * r.initial.kinetic);
  }
  EXPECT_EQ(run.w.clock.substeps, 8);
}

// The ledger records clamp, floor contact, damping and creep. Plastic flow does not depend on the number of
// substeps.
TEST(Substeps, LedgerClosesForWallsClampsAndCreep) {
  double plastic[2];
  for (const int n : {1, 8}) {
    Scene s = stiffBlock(n);
    s.domain.gravity = {0, 0, -10};
    s.domain.min = {-1, -1, -0.5};
    s.materials[0].damping = 5;
    s.materials[0].yieldStrain = {0.002, 0.002};
    s.materials[0].creepRate = {20, 20};
    s.bodies[0].shape.move = {0, 0, 0.13};
    s.bodies[0].clamp.push_back(boxOf({-1, -1, -1}, {-0.15, 1, 1}));
    addFloor(s);
    s.end = 0.2;
    Simulation run(s);
    EXPECT_TRUE(run.run());
    const LedgerReport r = run.ledgerReport();
    EXPECT_LT(length(r.momentumResidual), 1e-6 * length(r.gravityImpulse)) << n;
    EXPECT_LT(std::abs(r.energyResidual), 0.02 * r.energyScale) << n;
    double sum = 0;
    for (std::size_t k = 0; k < run.w.solids.owned; k++)
      sum += norm(plasticStrain(run.w.solids.plasticInverse[k], {}));
    plastic[n > 1] = sum;
    EXPECT_GT(sum, 0);
  }
  EXPECT_NEAR(plastic[1], plastic[0], 0.02 * plastic[0]);
}

// With 8 substeps the step is near half a period of modes of the undamped block, which pumps 0.8 % of the
// energy into it.
TEST(Substeps, KeepAStiffBlockInWaterStable) {
  for (const int n : {1, 4}) {
    Scene s = columnScene(0.01, 0, 0.3);
    s.domain.max = {0.12, 0.12, 0.3};
    s.domain.side[2] = {Side::Wall, Side::Open};
    s.domain.gravity = {0, 0, -9.81};
    s.numerics.elasticSubsteps = n;
    s.materials.emplace_back();
    s.materials[0].viscosity = {1, 1};
    s.materials[0].soundSpeed = 20;
    s.materials[1].name = "stiff";
    s.materials[1].density = 2000;
    s.materials[1].young = {3e7, 3e7};
    s.materials[1].law.name = "corotated";
    addBox(s, {0, 0, 0}, {0.12, 0.12, 0.08});
    Body& b = addBox(s, {0.03, 0.03, 0.09}, {0.09, 0.09, 0.13});
    b.material = 1;
    b.velocity = {0, 0, -1};
    s.end = 0.05;
    Simulation run(s);
    EXPECT_TRUE(run.run());
    EXPECT_EQ(run.w.clock.substeps, n);
    const LedgerReport r = run.ledgerReport();
    EXPECT_LT(length(r.momentumResidual), 1e-6 * length(r.gravityImpulse)) << n;
    EXPECT_LT(std::abs(r.energyResidual), 0.005 * r.energyScale) << n;
    std::printf("n %d: residual %.2e of %.3g J, elastic %.2e J, velocity %.4g m/s\n", n, r.energyResidual,
                r.energyScale, r.now.elastic, r.now.momentum.z);
  }
}

}  // namespace thaw::test
