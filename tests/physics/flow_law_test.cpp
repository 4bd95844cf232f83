// SPDX-License-Identifier: Apache-2.0
// Liquids with flow laws over whole steps: rates at walls, layers on slopes that flow, stop and stay,
// momentum and energy.
#include <gtest/gtest.h>

#include <cmath>

#include "core/fluid/flow_laws/flow_law.hpp"
#include "tests/support/flows.hpp"

namespace thaw::test {
namespace {

constexpr double dx = 0.01, height = 0.1, slope = 0.2;  // m, m, angle in rad

Material paste(FlowLaw law, double yield, double viscosity, double n) {
  Material m;
  m.name = "paste";
  m.soundSpeed = 2;
  m.flowLaw.law = law;
  m.flowLaw.yieldStress = {{0, yield}};
  m.flowLaw.consistency = {{0, viscosity}};
  m.flowLaw.exponent = n;
  m.flowLaw.leastRate = 1e-3;
  return m;
}

/// A layer on a plane that is inclined along x. The driving stress at its bottom is rho g H sin(slope), 195
/// Pa.
Scene layer(const Material& m) {
  Scene s = columnScene(dx, 0, 2 * height);
  s.domain.side[2] = {Side::Wall, Side::Open};
  s.domain.gravity = {9.81 * std::sin(slope), 0, -9.81 * std::cos(slope)};
  s.materials[0] = m;
  s.numerics.density = DensityForm::Continuity;
  s.numerics.viscositySolver = ViscositySolver::Implicit;
  s.numerics.viscosityCorrection = true;
  addBox(s, {0, 0, 0}, {6 * dx, 6 * dx, height});
  return s;
}

double largestSpeed(const Continuum& p) {
  double most = 0;
  for (std::size_t i = 0; i < p.owned; i++) most = std::max(most, length(p.velocity[i]));
  return most;
}

const double drive = 1000 * 9.81 * std::sin(slope) * height;  // Pa

}  // namespace

TEST(FlowLaw, RateIsThatOfALinearFlowAlsoAtTheWall) {
  Scene s = layer(paste(FlowLaw::PowerLaw, 0, 3, 0.5));
  Simulation run(s);
  Continuum& p = run.particles();
  for (std::size_t i = 0; i < p.owned; i++) p.velocity[i] = {4 * p.position[i].z, 0, 0};
  initializeForces(run.w, run.halos(), run.tools);
  for (std::size_t i = 0; i < p.owned; i++)
    EXPECT_NEAR(p.apparentViscosity[i], 3 * std::pow(4, -0.5), 0.01) << "z " << p.position[i].z;
}

TEST(FlowLaw, SteadyLayerOnASlopeHasItsExactProfile) {
  for (const double n : {1.0, 0.5, 1.5}) {
    const double yield = 0.25 * drive, K = 20, plug = yield / drive * height;
    Scene s = layer(paste(FlowLaw::HerschelBulkley, yield, K, n));
    s.end = 0.6;
    const auto exact = [&](double z) {
      const double y = std::max(height - z, plug) - plug, full = height - plug, k = 1 + 1 / n;
      return std::pow(drive / height / K, 1 / n) / k * (std::pow(full, k) - std::pow(y, k));
    };
    s.materials[0].soundSpeed = 10 * std::max(exact(height), 0.5);
    Simulation run(s);
    Continuum& p = run.particles();
    for (std::size_t i = 0; i < p.owned; i++) p.velocity[i].x = exact(p.position[i].z);
    ASSERT_TRUE(run.run());
    double square = 0;
    for (std::size_t i = 0; i < p.owned; i++)
      square += std::pow(p.velocity[i].x / exact(height) - exact(p.position[i].z) / exact(height), 2);
    const double error = std::sqrt(square / static_cast<double>(p.owned));
    std::printf("n %.1f: greatest speed %.3f m/s, L2 %.4f\n", n, exact(height), error);
    EXPECT_LT(error, 0.06);  // ten spacings high
  }
}

TEST(FlowLaw, LayerBelowItsYieldStressStopsAndStays) {
  Scene s = layer(paste(FlowLaw::Bingham, 2 * drive, 5, 1));
  s.end = 1;
  Simulation run(s);
  Continuum& p = run.particles();
  for (std::size_t i = 0; i < p.owned; i++) p.velocity[i] = {3 * p.position[i].z, 0, 0};
  initializeForces(run.w, run.halos(), run.tools);
  ASSERT_TRUE(run.run());
  double mean = 0;
  for (std::size_t i = 0; i < p.owned; i++) mean += p.velocity[i].x / static_cast<double>(p.owned);
  const double creep = s.materials[0].flowLaw.leastRate * height;
  std::printf("mean speed %.2e m/s, largest %.2e m/s, least rate times height %.2e m/s\n", mean,
              largestSpeed(p), creep);
  EXPECT_LT(std::abs(mean), creep);
  EXPECT_LT(largestSpeed(p), 5 * creep);  // vertical oscillations of the pressure included
}

TEST(FlowLaw, ExplicitAndImplicitFlowsAgree) {
  double mean[2];
  for (const ViscositySolver solver : {ViscositySolver::Explicit, ViscositySolver::Implicit}) {
    Material m = paste(FlowLaw::HerschelBulkley, 0.25 * drive, 20, 0.5);
    m.flowLaw.leastRate = 0.5;
    Scene s = layer(m);
    s.numerics.viscositySolver = solver;
    s.numerics.viscosityCorrection = false;  // its limits differ between the two
    s.end = 0.1;
    Simulation run(s);
    ASSERT_TRUE(run.run());
    const Continuum& p = run.particles();
    double& sum = mean[solver == ViscositySolver::Implicit];
    sum = 0;
    for (std::size_t i = 0; i < p.owned; i++) sum += p.velocity[i].x / static_cast<double>(p.owned);
  }
  std::printf("mean speed %.5f m/s explicit, %.5f m/s implicit\n", mean[0], mean[1]);
  EXPECT_NEAR(mean[1] / mean[0], 1, 0.02);
}

TEST(FlowLaw, MomentumAndEnergyAreKept) {
  for (const ViscositySolver solver : {ViscositySolver::Explicit, ViscositySolver::Implicit}) {
    Scene s = emptyScene(0.05, {-1, -1, -1}, {1, 1, 1});
    s.materials.push_back(paste(FlowLaw::HerschelBulkley, 20, 10, 0.7));
    s.materials[0].flowLaw.leastRate = 0.5;
    s.numerics.viscositySolver = solver;
    addBox(s, {-0.3, -0.3, -0.3}, {0.3, 0.3, 0.3}).spin = {0, 0, 1};
    s.end = 0.1;
    Simulation run(s);
    Continuum& p = run.particles();
    for (std::size_t i = 0; i < p.owned; i++) p.velocity[i].x += p.position[i].z;
    initializeForces(run.w, run.halos(), run.tools);
    run.w.ledger.initial = run.ledgerReport().now;
    ASSERT_TRUE(run.run());
    const LedgerReport r = run.ledgerReport();
    EXPECT_LT(length(r.momentumResidual), 1e-12 * r.initial.mass);
    EXPECT_LT(length(r.now.angularMomentum - r.initial.angularMomentum),
              1e-4 * length(r.initial.angularMomentum));
    EXPECT_LT(std::abs(r.energyResidual), 0.02 * r.initial.kinetic);
  }
}

}  // namespace thaw::test
