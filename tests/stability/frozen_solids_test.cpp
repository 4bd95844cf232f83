// SPDX-License-Identifier: Apache-2.0
// Failures of solids that are frozen, coincident, or few particles: rows of docs/validation/stability.md.
// Each test provokes the failure and checks the stated behaviour of thaw.
#include "core/domain/emit.hpp"
#include "core/solid/elasticity/moment.hpp"
#include "core/solid/laws/response.hpp"
#include "tests/support/measured.hpp"
#include "tests/support/moving_body.hpp"
#include "tests/support/simulation.hpp"

namespace thaw::test {

TEST(Stability, Row13PulledMoltenFlownFrozen) {
  Scene s;
  s.spacing = 0.02;
  s.domain.min = {-1, -1, -1};
  s.domain.max = {1, 1, 1};
  s.domain.gravity = {};
  s.output.every = 0;
  s.materials.emplace_back();
  Material& m = s.materials[0];
  m.young = {1e5, 0};
  m.law.name = "neo-hookean";
  m.viscosity = {20, 20};
  m.soundSpeed = 10;
  m.conductivity = {1, 1};
  m.heatCapacity = {1000, 1000};
  m.latentHeat = 1e4;
  m.solidus = 300, m.liquidus = 310;
  addBox(s, {-0.1, -0.06, -0.06}, {0.1, 0.06, 0.06}).temperature = 299;
  s.bodies[0].temperatureGradient = {1e-6, 0, 0};  // switches heat on
  s.end = 10;
  Simulation run(s);
  Continuum& p = run.particles();
  std::vector<Vec3d> start(p.owned);
  for (std::size_t i = 0; i < p.owned; i++) start[numberOf(p.id[i])] = p.position[i];
  const auto setHeat = [&](double H) {
    for (std::size_t i = 0; i < p.owned; i++) p.enthalpy[i] = H;
  };
  const auto steps = [&](double time) {
    for (const double until = run.w.clock.time + time; run.w.clock.time < until;) ASSERT_TRUE(run.step());
  };
  for (std::size_t i = 0; i < p.owned; i++) p.velocity[i] = {4 * p.position[i].x, 0, 0};  // pull
  steps(0.02);
  setHeat(5e4);  // melt
  steps(0.002);
  EXPECT_EQ(run.w.counters.melted, static_cast<std::int64_t>(p.owned));
  // flow: sheared to twice its height along x
  for (std::size_t i = 0; i < p.owned; i++) p.velocity[i] = {30 * p.position[i].z, 0, -5 * p.position[i].z};
  steps(0.06);
  setHeat(-5e3);  // freeze
  steps(0.001);
  EXPECT_EQ(run.w.counters.frozen, static_cast<std::int64_t>(p.owned));
  const double frozen = run.ledgerReport().now.elastic, moving = run.ledgerReport().now.kinetic;
  // the same flow with the initial bonds
  std::vector<Vec3d> places(p.owned);
  for (std::size_t i = 0; i < p.owned; i++) places[numberOf(p.id[i])] = p.position[i];
  std::vector<Vec3d> was, is;
  for (std::size_t k = 0; k < places.size(); k++) was.push_back(start[k]), is.push_back(places[k]);
  BodyOptions options;
  options.spacing = s.spacing;
  options.support = s.numerics.support;
  const auto stale = makeBody(was, {m}, options);
  moveAll(*stale, is, [](const Vec3d& x) { return x; });
  computeForces(*stale);
  steps(0.1);
  const LedgerReport r = run.ledgerReport();
  measured(
      "elastic energy just after freezing: %.3g J with the old reference, %.3g J (kinetic %.3g J); phase "
      "recorded jump %.3g J",
      totalEnergy(*stale), frozen, moving, r.phaseJump);
  EXPECT_GT(totalEnergy(*stale), 10 * moving);
  EXPECT_LT(frozen, 0.1 * moving);
  EXPECT_LT(r.now.kinetic + r.now.elastic, 1.05 * (moving + frozen));
}

TEST(Stability, Row09CoincidentSolids) {
  // two bodies in the same place, which only overlap = "keep" allows
  Scene s;
  s.spacing = 0.1;
  s.domain.gravity = {};
  s.output.every = 0;
  s.numerics.overlap = OverlapRule::Keep;
  s.materials.emplace_back();
  s.materials[0].young = {1e5, 0};
  addBox(s, {-0.05, -0.05, -0.05}, {0.05, 0.05, 0.05});
  addBox(s, {-0.05, -0.05, -0.05}, {0.05, 0.05, 0.05});
  s.end = 0.1;
  Simulation run(s);
  ASSERT_EQ(run.particles().owned, 2u);
  EXPECT_TRUE(run.run());
  const double apart = length(run.particles().position[0] - run.particles().position[1]) / s.spacing;
  measured("apart by %.2f spacings after 0.1 s; %lld counted", apart,
           static_cast<long long>(run.w.counters.coincidentPairs));
  EXPECT_GT(apart, 0.3);
  EXPECT_GT(run.w.counters.coincidentPairs, 0);
}

TEST(Stability, Row21LonelyParticlesAndSmallClusters) {
  // Thrown solids and liquids of one to four particles: their centres of mass are ballistic, and all values
  // stay finite.
  const double dx = 0.01;
  double worst = 0, residual = 0;
  for (const bool solid : {false, true})
    for (int n = 1; n <= 4; n++) {
      Scene s;
      s.spacing = dx;
      s.domain.min = {-1, -1, -2};
      s.domain.max = {1, 1, 1};
      s.domain.gravity = {0, 0, -9.81};
      s.output.every = 0;
      s.numerics.precision = Precision::Double;
      s.materials.emplace_back();
      Material& m = s.materials[0];
      if (solid) m.young = {1e4, 0};
      m.viscosity = {0.01, 0.01};
      m.surfaceTension = 0.07;
      m.soundSpeed = 20;
      Body& b = addBox(s, {0, 0, 0}, {n * dx, dx, dx});
      b.velocity = {0.3, 0.1, 2};
      b.spin = {0, 0, 3};
      s.end = 0.4;
      Simulation run(s);
      ASSERT_EQ(run.particles().owned, static_cast<std::size_t>(n));
      Vec3d first{}, last{};
      for (int i = 0; i < n; i++) first += run.particles().position[static_cast<std::size_t>(i)] / double(n);
      ASSERT_TRUE(run.run());
      for (int i = 0; i < n; i++) last += run.particles().position[static_cast<std::size_t>(i)] / double(n);
      const Vec3d exact = first + b.velocity * s.end + 0.5 * s.end * s.end * s.domain.gravity;
      worst = std::max(worst, length(last - exact) / dx);
      residual = std::max(residual,
                          std::abs(run.ledgerReport().energyResidual) / run.ledgerReport().energyScale);
      EXPECT_EQ(run.w.counters.singularNeighbourhoods, solid ? n : 0);
    }
  measured(
      "1 to 4 particles, liquid and solid: centre of mass within %.1e spacings of the parabola, energy "
      "within %.1e",
      worst, residual);
  EXPECT_LT(worst, 1e-6);
  EXPECT_LT(residual, 1e-3);
}

}  // namespace thaw::test
