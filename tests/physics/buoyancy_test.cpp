// SPDX-License-Identifier: Apache-2.0
// Buoyancy of liquids against exact solutions and the ledger.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <utility>

#include "tests/support/simulation.hpp"

namespace thaw::test {
namespace {

using std::numbers::pi;
constexpr double g = 10, expansion = 0.01, amplitude = 5;  // m/s^2, 1/K, K

/// A periodic box full of liquid that expands, with gravity along -z.
Scene fullBox(double dx, const Vec3d& size) {
  Scene s = emptyScene(dx, {0, 0, 0}, size);
  for (auto& side : s.domain.side) side = {Side::Periodic, Side::Periodic};
  s.domain.buoyantGravity = {0, 0, -g};
  s.numerics.buoyancy = Buoyancy::Boussinesq;
  s.materials.emplace_back();
  s.materials[0].name = "liquid";
  s.materials[0].expansion = expansion;
  s.materials[0].expansionFrom = 300;
  addBox(s, s.domain.min, s.domain.max);
  return s;
}

/// A box of edge 1 with hot and cold columns of cells: T = 300 + A cos(2 pi x) cos(2 pi z).
Scene cells(PressureSolver solver) {
  constexpr double dx = 0.05;
  Scene s = fullBox(dx, {1, 6 * dx, 1});
  s.materials[0].density = 1;
  Body& b = s.bodies[0];
  b.temperatureField.text = "A cos cos";
  b.temperatureField.value = [](const Vec3d& x) {
    return 300 + amplitude * std::cos(2 * pi * x.x) * std::cos(2 * pi * x.z);
  };
  Numerics& n = s.numerics;
  n.solver = solver;
  n.tensileLimit = 1;
  if (solver == PressureSolver::StateEquation) {
    n.density = DensityForm::Continuity;
    n.shifting = 0.2;
  }
  return s;
}

/// Amplitude (m/s) of cos(2 pi x) cos(2 pi z) in the vertical velocity.
double risingMode(const Continuum& p) {
  double sum = 0;
  for (std::size_t i = 0; i < p.owned; i++)
    sum += p.velocity[i].z * std::cos(2 * pi * p.position[i].x) * std::cos(2 * pi * p.position[i].z);
  return 4 * sum / static_cast<double>(p.owned);
}

/// Pressure cancels half of the force of this mode: w = g beta A t / 2. momentum: its tolerance over the
/// mass.
void expectStartOfConvection(PressureSolver solver, double momentum) {
  Scene s = cells(solver);
  s.end = 0.3;
  Simulation run(s);
  ASSERT_TRUE(run.w.modules.buoyancy);
  ASSERT_TRUE(run.run());
  const double exact = 0.5 * g * expansion * amplitude * run.w.clock.time;
  EXPECT_NEAR(risingMode(run.particles()), exact, 0.03 * exact);
  const LedgerReport r = run.ledgerReport();
  EXPECT_GT(r.wallWork, 0.9 * r.now.kinetic);
  EXPECT_LT(std::abs(r.energyResidual), 0.01 * r.wallWork);
  EXPECT_LT(length(r.momentumResidual), momentum * r.now.mass);
}

}  // namespace

TEST(BuoyancyInAClosedBox, StartsConvectionAtItsExactRate) {
  expectStartOfConvection(PressureSolver::StateEquation, 1e-12);
}

TEST(BuoyancyInAClosedBox, StartsConvectionAtItsExactRateInIncompressibleLiquid) {
  expectStartOfConvection(PressureSolver::Incompressible, 1e-8);  // its pressures are in single precision
}

// Warm and cold layers slide past each other, and their particles become disordered. Their summed densities
// then exceed that of the lattice. If the solver resisted this excess, its pressure would slow the flow.
TEST(BuoyancyInAClosedBox, DrivesLayersInIncompressibleLiquid) {
  constexpr double edge = 0.1, viscosity = 1, density = 1000, k = 2 * pi / edge;
  Scene s = fullBox(edge / 16, {edge, edge / 2, edge / 2});
  s.materials[0].density = density;
  s.materials[0].viscosity = {viscosity, viscosity};
  Body& b = s.bodies[0];
  b.packing = Packing::Relaxed;
  b.temperatureField.text = "A cos";
  b.temperatureField.value = [](const Vec3d& x) { return 300 + std::cos(k * x.x); };
  s.numerics.solver = PressureSolver::Incompressible;
  s.end = 2;
  Simulation run(s);
  ASSERT_TRUE(run.run());
  const Continuum& p = run.particles();
  double speed = 0;
  for (std::size_t i = 0; i < p.owned; i++)
    speed += 2 * p.velocity[i].z * std::cos(k * p.position[i].x) / static_cast<double>(p.owned);
  const double decay = viscosity / density * k * k;
  EXPECT_NEAR(speed * decay / (g * expansion), 1 - std::exp(-decay * run.w.clock.time), 0.1);
}

TEST(BuoyancyInAClosedBox, OffsetOfTheReferenceTemperatureChangesNothing) {
  Scene s = cells(PressureSolver::StateEquation);
  s.end = 0.05;
  Simulation near(s);
  ASSERT_TRUE(near.run());
  s.materials[0].expansionFrom = 250;
  Simulation far(s);
  ASSERT_TRUE(far.run());
  EXPECT_NEAR(risingMode(near.particles()), risingMode(far.particles()), 1e-9);
}

TEST(BuoyancyWithWeight, ChangesTheFallOfLiquid) {
  constexpr double dx = 0.1;
  Scene s = emptyScene(dx, {0, 0, -10}, {10, 1, 1});
  s.domain.gravity = {0, 0, -g};
  s.numerics.buoyancy = Buoyancy::Density;
  s.materials.emplace_back();
  s.materials[0].expansion = expansion;
  s.materials[0].expansionFrom = 300;
  addBox(s, {1, 0, 0}, {1 + dx, dx, dx}).temperature = 300;
  addBox(s, {5, 0, 0}, {5 + dx, dx, dx}).temperature = 320;
  s.end = 0.5;
  Simulation run(s);
  ASSERT_EQ(run.particles().owned, 2u);
  ASSERT_TRUE(run.run());
  for (std::size_t i = 0; i < 2; i++) {
    const double share = run.particles().position[i].x < 3 ? 1 : 0.8;
    EXPECT_NEAR(run.particles().velocity[i].z, -g * share * run.w.clock.time, 1e-9);
  }
  const LedgerReport r = run.ledgerReport();
  EXPECT_LT(r.wallWork, 0);
  EXPECT_LT(std::abs(r.energyResidual), 1e-10 * r.now.kinetic);
  EXPECT_LT(length(r.momentumResidual), 1e-10 * r.now.mass);
}

}  // namespace thaw::test
