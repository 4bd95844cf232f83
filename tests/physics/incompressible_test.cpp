// SPDX-License-Identifier: Apache-2.0
// The incompressible pressure solver over whole steps: conservation and number of steps.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/fluid/laws/particle_pressure.hpp"
#include "tests/support/flows.hpp"

namespace thaw::test {
namespace {

/// Mean excess of the relative density over the value from which liquid resists
/// (PressureWork::targetRelativeDensity).
double compression(const Simulation& run) {
  const Continuum& p = run.w.particles;
  double sum = 0;
  for (std::size_t i = 0; i < p.owned; i++)
    sum += std::max(0.0,
                    static_cast<double>(p.relativeDensity[i]) - run.tools.pressure.targetRelativeDensity);
  return sum / static_cast<double>(p.owned);
}

Scene hydrostatic() {
  const double dx = 0.1, H = 10 * dx;
  Scene s = columnScene(dx, 0, 16 * dx);
  s.domain.side[2][0] = Side::Wall;
  s.domain.gravity = {0, 0, -10};
  s.materials[0].viscosity = {500, 500};
  s.numerics.solver = PressureSolver::Incompressible;
  addBox(s, {0, 0, 0}, {6 * dx, 6 * dx, H});
  s.end = 2;
  return s;
}

/// Water at rest in a coarse tank.
Scene tank() {
  Scene s = liquidInABox(0.02, {0.4, 0.12, 0.4}, {0.4, 0.12, 0.2}, 1e-3f);
  s.numerics.solver = PressureSolver::Incompressible;
  s.domain.side[1] = {Side::Periodic, Side::Periodic};
  s.end = 1;
  return s;
}

/// Liquid of 8 layers and one wavelength, 1 m, with g = 1 m/s^2.
Scene basin() {
  const double dx = 1.0 / 32;
  Scene s = emptyScene(dx, {0, 0, 0}, {1, 6 * dx, 0.5});
  s.domain.side[0] = s.domain.side[1] = {Side::Periodic, Side::Periodic};
  s.domain.side[2] = {Side::Wall, Side::Open};
  s.domain.gravity = {0, 0, -1};
  s.materials.emplace_back();
  s.materials[0].soundSpeed = 5;
  s.materials[0].viscosity = {0.5, 0.5};
  s.numerics.solver = PressureSolver::Incompressible;
  addBox(s, {0, 0, 0}, {1, 6 * dx, 0.25});
  s.end = 2.2;
  return s;
}

/// Water falls to the right in a closed box.
Scene dam() {
  Scene s = liquidInABox(0.02, {0.4, 0.12, 0.4}, {0.16, 0.12, 0.24}, 1);
  s.end = 0.3;
  return s;
}

}  // namespace

// In longer steps, the fall of each half step would set it in motion.
TEST(Incompressible, CoarseWaterAtRestStaysCalm) {
  Simulation run(tank());
  double most = 0;
  while (run.w.clock.time < run.w.clock.end) {
    ASSERT_TRUE(run.step());
    most = std::max(most, run.ledgerReport().now.kinetic);
  }
  EXPECT_LT(most, 0.02);  // J, 6 cm/s; 3 J in steps of 0.25 sqrt(h / g)
}

TEST(Incompressible, HydrostaticColumnKeepsItsDensity) {
  const Scene s = hydrostatic();
  Simulation run(s);
  const Continuum& p = run.particles();
  double most = 0;
  while (run.w.clock.time < s.end) {
    ASSERT_TRUE(run.step());
    most = std::max(most, compression(run));
  }
  EXPECT_LT(most, 1.5 * s.numerics.densityTolerance);
  double square = 0, fastest = 0;
  for (std::size_t i = 0; i < p.owned; i++) {
    square += std::pow((static_cast<double>(pressureOfParticle(run.w.scene, run.w.modules, run.w.particles,
                                                               run.tools.liquids, i)) -
                        10000 * (1 - p.position[i].z)) /
                           10000,
                       2);
    fastest = std::max(fastest, length(p.velocity[i]));
  }
  // the limit of the state equation (walls_test.cpp)
  EXPECT_LT(std::sqrt(square / static_cast<double>(p.owned)), 0.08);
  EXPECT_LT(fastest, 0.02 * std::sqrt(10.0));
  EXPECT_EQ(run.w.counters.unsolvedPressures, 0);
  const LedgerReport r = run.ledgerReport();
  EXPECT_LT(length(r.momentumResidual), 1e-6 * length(r.gravityImpulse));
}

// With uncorrected gradients, liquid under pressure resists shear like a soft solid: waves are 14 % too fast.
TEST(Incompressible, GravityWavesHaveTheirFrequency) {
  Simulation run(basin());
  Continuum& p = run.particles();
  const double k = 2 * std::numbers::pi, exact = std::sqrt(k * std::tanh(0.25 * k));  // Airy
  const auto mode = [k](const Vec3d& x) {
    return Vec3d{std::cosh(k * x.z) * std::cos(k * x.x), 0, std::sinh(k * x.z) * std::sin(k * x.x)};
  };
  for (std::size_t i = 0; i < p.owned; i++) p.velocity[i] = mode(p.position[i]) * 0.02;
  initializeForces(run.w, run.halos(), run.tools);
  std::vector<double> zeros;
  for (double before = 1, then = 0; run.w.clock.time < run.w.clock.end; then = run.w.clock.time) {
    ASSERT_TRUE(run.step());
    double now = 0;
    for (std::size_t i = 0; i < p.owned; i++) now += dot(p.velocity[i], mode(p.position[i]));
    if (now * before < 0) zeros.push_back(then + (run.w.clock.time - then) * before / (before - now));
    before = now;
  }
  ASSERT_EQ(zeros.size(), 2u);
  EXPECT_NEAR(std::numbers::pi / (zeros[1] - zeros[0]), exact, 0.03 * exact);
}

TEST(Incompressible, DamBreakNeedsFewSteps) {
  Scene s = dam();
  Simulation stiff(s);
  ASSERT_TRUE(stiff.run());
  s.numerics.solver = PressureSolver::Incompressible;
  Simulation run(s);
  ASSERT_TRUE(run.run());
  EXPECT_LT(5 * run.w.clock.step, stiff.w.clock.step);
  EXPECT_EQ(run.w.counters.unsolvedPressures, 0);
  // The tolerance bounds the remaining share of a step's compression, not the compression of splashes. That
  // stays below the limit of a state equation.
  EXPECT_LT(compression(run), s.numerics.maxDensityError);
  const LedgerReport a = stiff.ledgerReport(), b = run.ledgerReport();
  EXPECT_NEAR(b.now.potential, a.now.potential, 0.1 * a.initial.potential);
  EXPECT_LT(length(b.momentumResidual), 1e-6 * length(b.gravityImpulse));
  EXPECT_LT(std::abs(b.energyResidual), 0.02 * b.energyScale);
}

TEST(Incompressible, NegativePressureDoesNotTearTheFreeSurface) {
  Scene s = emptyScene(0.02, {-0.4, -0.4, -0.4}, {0.4, 0.4, 0.4});
  s.numerics.solver = PressureSolver::Incompressible;
  s.numerics.tensileLimit = 1;
  s.materials.emplace_back();
  addBox(s, {-0.1, -0.1, -0.1}, {0.1, 0.1, 0.1}).packing = Packing::Relaxed;
  s.end = 0.1;
  Simulation run(s);
  EXPECT_TRUE(run.run());
  double fastest = 0;
  for (std::size_t i = 0; i < run.particles().owned; i++) {
    fastest = std::max(fastest, length(run.particles().velocity[i]));
    // no next step would limit it
    EXPECT_TRUE(std::isfinite(length(run.particles().pressureImpulse[i])));
  }
  EXPECT_LT(fastest, 0.05);  // from its packing; closing the surface gaps in one step would give 1000 m/s
}

// Two drops collide; no walls, no gravity.
TEST(Incompressible, MomentumIsConserved) {
  Scene s = emptyScene(0.02, {-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5});
  s.materials.emplace_back();
  s.materials[0].viscosity = {0.1, 0.1};
  s.numerics.solver = PressureSolver::Incompressible;
  addBox(s, {-0.14, -0.06, -0.06}, {-0.02, 0.06, 0.06}).velocity = {1, 0, 0};
  addBox(s, {0.02, -0.02, -0.06}, {0.14, 0.10, 0.06}).velocity = {-1, 0, 0};
  s.end = 0.15;
  Simulation run(s);
  ASSERT_TRUE(run.run());
  const LedgerReport r = run.ledgerReport();
  const double scale = 0.5 * r.now.mass;  // kg m/s, of one drop
  EXPECT_LT(length(r.now.momentum), 1e-6 * scale);
  EXPECT_LT(length(r.now.angularMomentum - r.initial.angularMomentum),
            1e-4 * length(r.initial.angularMomentum));
  EXPECT_LT(r.now.kinetic, 0.9 * r.initial.kinetic);
  EXPECT_LT(std::abs(r.energyResidual), 0.01 * r.energyScale);
}

// A layer of wax freezes from below under its weight. Frozen particles keep no pressure of their last step as
// a liquid. Their pairs with other solids are summed only if a liquid shares their group of eight. These
// groups depend on the number of ranks.
TEST(Incompressible, ImpactAtTheStartIsDissipated) {
  // Two halves of a block meet: the first pressure stops most of their motion.
  Scene s = emptyScene(0.02, {-0.4, -0.4, -0.4}, {0.4, 0.4, 0.4});
  s.numerics.solver = PressureSolver::Incompressible;
  s.materials.push_back({});
  s.materials[0].density = 1000;
  s.materials[0].soundSpeed = 10;
  addBox(s, {-0.1, -0.1, -0.1}, {0, 0.1, 0.1}).velocity = {1, 0, 0};
  addBox(s, {0, -0.1, -0.1}, {0.1, 0.1, 0.1}).velocity = {-1, 0, 0};
  s.end = 0.02;
  Simulation run(s);
  const double initial = run.w.ledger.initial.kinetic;
  EXPECT_LT(run.ledgerReport().now.kinetic, 0.7 * initial);
  ASSERT_TRUE(run.run());
  EXPECT_LT(std::abs(run.ledgerReport().energyResidual), 0.02 * initial);
}

TEST(Incompressible, FrozenParticlesHaveNoPressure) {
  Scene s = emptyScene(0.01, {-0.03, -0.03, 0}, {0.03, 0.03, 0.2});
  for (auto& side : s.domain.side) side = {Side::Wall, Side::Wall};
  s.domain.gravity = {0, 0, -9.81};
  s.materials.push_back(wax());
  s.numerics.solver = PressureSolver::Incompressible;
  addBox(s, {-0.03, -0.03, 0}, {0.03, 0.03, 0.06}).temperature = 341;
  addFloor(s).temperature = 203;
  s.end = 0.6;
  Simulation run(s);
  const Continuum& p = run.particles();
  std::vector<std::uint64_t> solid, now;
  double largest = 0;
  while (run.w.clock.time < s.end) {
    ASSERT_TRUE(run.step());
    now.clear();
    for (std::size_t i = 0; i < p.owned; i++) {
      largest = std::max(largest, static_cast<double>(p.densityPressure[i]));
      if (p.liquid[i] > 0) continue;
      now.push_back(p.id[i]);
      if (!std::binary_search(solid.begin(), solid.end(), p.id[i])) continue;
      ASSERT_EQ(p.densityPressure[i], 0) << p.id[i];
      ASSERT_EQ(p.divergencePressure[i], 0) << p.id[i];
    }
    std::sort(now.begin(), now.end());
    solid.swap(now);
  }
  EXPECT_GT(solid.size(), 20u);
  EXPECT_GT(largest, 50);  // Pa: there was a pressure to keep
}

}  // namespace thaw::test
