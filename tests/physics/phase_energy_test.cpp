// SPDX-License-Identifier: Apache-2.0
// The ledger has the change of stored energy where particles melt or freeze by any amount within a step.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "core/materials/enthalpy.hpp"
#include "tests/support/simulation.hpp"

namespace thaw::test {
namespace {

constexpr double dx = 0.01;

/// Wax at 300 K that melts from 313 K, in short steps of double precision.
Scene waxScene() {
  Scene s = emptyScene(dx, {-1, -1, -1}, {1, 1, 1});
  s.domain.gravity = {0, 0, -9.81};
  s.numerics.precision = Precision::Double;
  s.numerics.density = DensityForm::Continuity;
  s.materials.push_back(wax());
  s.materials[0].young = {2e4, 0};
  s.materials[0].conductivity = {0.1, 0.1};
  s.materials[0].viscosity = {0.01, 0.01};  // its loss would begin with half a kick
  s.materials[0].soundSpeed = 10;
  s.end = 1;
  return s;
}

/// Cube of `side` particles whose lowest layer begins at `height`.
Body& addCube(Scene& s, int side, double height) {
  Body& b = addBox(s, {-0.5 * side * dx, -0.5 * side * dx, height},
                   {0.5 * side * dx, 0.5 * side * dx, height + side * dx});
  b.temperature = 300;
  b.temperatureGradient = {1e-6, 0, 0};  // switches heat on
  return b;
}

/// Brings chosen particles to a liquid fraction with the next step.
void soften(Simulation& run, double fraction,
            const std::function<bool(const Continuum&, std::size_t)>& chosen) {
  Continuum& p = run.particles();
  for (std::size_t i = 0; i < p.owned; i++)
    if (chosen(p, i))
      p.enthalpy[i] = fraction * meltingBand(run.w.scene.materials[p.material[i]]) + (fraction < 1 ? 0 : 1e3);
}
bool everyone(const Continuum&, std::size_t) { return true; }

/// Entries over a few steps (J).
struct Change {
  double jump = 0, residual = 0;
};

Change changeOver(Simulation& run, int steps) {
  const LedgerReport before = run.ledgerReport();
  for (int k = 0; k < steps; k++) EXPECT_TRUE(run.step());
  const LedgerReport after = run.ledgerReport();
  return {after.phaseJump - before.phaseJump, after.energyResidual - before.energyResidual};
}

void expectClosed(Simulation& run, double tolerance) {
  const Change c = changeOver(run, 2);
  EXPECT_GT(std::abs(c.jump), 1e-7);
  EXPECT_LT(std::abs(c.residual), tolerance * std::abs(c.jump)) << c.jump;
}

void runTo(Simulation& run, double time) {
  while (run.w.clock.time < time) ASSERT_TRUE(run.step());
}

}  // namespace

TEST(PhaseEnergy, LedgerHasTheSpringsOfSolidsThatMeltOnAnObstacle) {
  for (const double time : {0.017, 0.023})  // approaching and leaving
    for (const double fraction : {0.3, 0.9, 1.0}) {
      SCOPED_TRACE(testing::Message() << time << " s, " << fraction);
      Scene s = waxScene();
      s.numerics.fixedStep = 2e-5;
      addFloor(s);
      addCube(s, 4, 0.004).velocity = {0, 0, -0.3};
      Simulation run(s);
      runTo(run, time);
      const double height = 0.5 * dx;
      soften(run, fraction, [&](const Continuum& p, std::size_t i) { return p.position[i].z < height; });
      expectClosed(run, 0.01);
    }
}

TEST(PhaseEnergy, LedgerHasTheContactsOfSolidsThatMelt) {
  for (const double fraction : {0.3, 0.9, 1.0})
    for (const bool both : {false, true}) {
      SCOPED_TRACE(testing::Message() << fraction << (both ? " both" : " upper"));
      Scene s = waxScene();
      s.numerics.fixedStep = 2e-5;
      addFloor(s);
      addCube(s, 4, 0);
      addCube(s, 4, 4.05 * dx).velocity = {0, 0, -0.3};
      Simulation run(s);
      runTo(run, 0.012);
      soften(run, fraction, [&](const Continuum& p, std::size_t i) {
        const double z = p.position[i].z / dx;
        return z > (both ? 3 : 3.9) && z < 4.9;
      });
      expectClosed(run, 0.02);
    }
}

TEST(PhaseEnergy, LedgerHasTheElasticEnergyOfSofteningSolids) {
  for (const bool volume : {false, true})
    for (const double poisson : {0.3, 0.45}) {
      SCOPED_TRACE(testing::Message() << volume << " " << poisson);
      Scene s = waxScene();
      s.domain.gravity = {};
      s.numerics.fixedStep = 2e-5;
      s.materials[0].volumeStiffness = volume ? 3e4 : 0;
      s.materials[0].poisson = {0.3, poisson};
      addCube(s, 5, 0);
      Simulation run(s);
      Continuum& p = run.particles();
      for (std::size_t i = 0; i < p.owned; i++)
        p.velocity[i] = {8 * p.position[i].x, 3 * p.position[i].x, -2 * p.position[i].z};
      runTo(run, 0.008);
      soften(run, 0.6, everyone);
      expectClosed(run, 0.02);
    }
}

TEST(PhaseEnergy, LedgerHasTheTensionOfParticlesThatMelt) {
  for (const TensionForm form : {TensionForm::Pairwise, TensionForm::SurfaceEnergy})
    for (const double fraction : {0.4, 1.0}) {
      SCOPED_TRACE(testing::Message() << static_cast<int>(form) << " " << fraction);
      Scene s = waxScene();
      s.domain.gravity = {};
      s.numerics.fixedStep = 2e-5;
      s.numerics.tension = form;
      s.materials[0].surfaceTension = 0.05;
      addCube(s, 4, 0).temperature = 325;
      Simulation run(s);
      soften(run, 0.2, everyone);
      runTo(run, 0.002);
      soften(run, fraction, everyone);
      expectClosed(run, 0.01);
    }
}

// A solid beside liquid has no energy of tension or compression until it melts.
TEST(PhaseEnergy, LedgerHasTheEnergyOfSolidsThatBeginToMeltBesideLiquid) {
  for (const bool tension : {false, true}) {
    SCOPED_TRACE(tension);
    Scene s = waxScene();
    s.domain.gravity = {};
    s.numerics.fixedStep = 2e-5;
    s.numerics.density = DensityForm::Summation;
    s.numerics.tension = TensionForm::SurfaceEnergy;
    if (tension) s.materials[0].surfaceTension = 0.05;
    addCube(s, 4, 0);
    addCube(s, 4, 4 * dx).temperature = 400;
    Simulation run(s);
    Continuum& p = run.particles();
    for (std::size_t i = 0; i < p.owned; i++) p.velocity[i] = p.position[i] * -2.0;
    runTo(run, 0.004);
    soften(run, 0.5, [](const Continuum& q, std::size_t i) { return q.position[i].z > 2.1 * dx; });
    expectClosed(run, 0.02);
  }
}

namespace {

/// Entries of particles on a floor whose volumes change after they melted, and the energy of their springs.
struct Growth {
  double jump, springs;
};

Growth growthOnFloor(double tension) {
  Scene s = waxScene();
  s.numerics.fixedStep = 2e-5;
  s.numerics.tension = TensionForm::SurfaceEnergy;
  Material& m = s.materials[0];
  m.surfaceTension = tension;
  m.solidDensity = 990;
  m.hysteresis = 0.2;
  addFloor(s);
  addCube(s, 4, 0.004).velocity = {0, 0, -1};
  Simulation run(s);
  runTo(run, 0.008);
  soften(run, 0.9, [](const Continuum& p, std::size_t i) { return p.position[i].z < 0.5 * dx; });
  changeOver(run, 2);
  const Continuum& p = run.particles();
  double springs = 0;
  for (std::size_t i = 0; i < p.owned; i++) springs += p.phase[i] == Liquid ? p.interaction[i] : 0;
  return {changeOver(run, 50).jump, springs};
}

}  // namespace

// A volume that changes with the phase changes the energy of tension, but not that of springs.
TEST(PhaseEnergy, ChangingVolumesLeaveTheEnergyOfSprings) {
  const Growth with = growthOnFloor(1e-10), without = growthOnFloor(0);
  constexpr double growth = 50 * 1e-3 * 10 / (2 * dx) * 2e-5;  // restDensityRate c / h, over 50 steps
  EXPECT_GT(with.springs, 1e-6);
  EXPECT_LT(std::abs(with.jump - without.jump), 0.1 * growth * with.springs);
}

}  // namespace thaw::test
