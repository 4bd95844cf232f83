// SPDX-License-Identifier: Apache-2.0
// Failures of time steps and heat: rows of docs/validation/stability.md.
#include "core/heat/heat.hpp"
#include "core/kernels/lattice.hpp"
#include "core/materials/enthalpy.hpp"
#include "core/simulation/views/views.hpp"
#include "tests/support/hashed.hpp"
#include "tests/support/measured.hpp"
#include "tests/support/periodic_block.hpp"

namespace thaw::test {
namespace {

constexpr double dx = 0.01;

/// A measure that grows if steps are too long: kinetic, elastic and potential energy, or the spread of
/// temperature.
double residualForce(Simulation& run) {
  const Balance b = run.ledgerReport().now;
  const Continuum& p = run.particles();
  double t = 0;
  for (std::size_t i = 0; i < p.owned && p.temperature.active; i++)
    t += (p.temperature[i] - 300) * (p.temperature[i] - 300);
  return b.kinetic + b.elastic + b.potential + t;
}

/// Growth of that measure over `steps` steps of length `fixed` (s; 0: automatic).
struct Growth {
  double factor, dt;
  const char* limitedBy;
  bool finite;
};
Growth growthOf(Scene s, double fixed, int steps, double jitter, double speed, double warmth) {
  s.numerics.fixedStep = fixed;
  s.end = 1e9;
  Simulation run(s);
  Continuum& p = run.particles();
  for (std::size_t i = 0; i < p.owned; i++)
    for (int a = 0; a < 3; a++) {
      const double r = hashed(3 * p.id[i] + static_cast<std::uint64_t>(a)) - 0.5;
      p.position[i][a] += jitter * dx * r;
      p.velocity[i][a] = speed * r;
      if (p.temperature.active && warmth > 0)
        p.enthalpy[i] = enthalpyOf(s.materials[0], 300 + warmth * r), p.temperature[i] = 300 + warmth * r;
    }
  const double dt = fixed > 0 ? fixed : run.w.clock.dt;
  if (fixed == 0) run.w.clock.dt = dt;
  EXPECT_TRUE(run.step());
  const double first = residualForce(run);
  Growth g{1, run.w.clock.dt, run.w.clock.limitedBy, true};
  for (int n = 0; n < steps && g.finite && g.factor < 1e6; n++) {
    g.finite = run.step();
    g.factor = g.finite ? residualForce(run) / first : never;
  }
  return g;
}

}  // namespace

TEST(Stability, Row10StepTooLong) {
  // Each limit of the step: stable with the default, unstable slightly beyond the stability limit.
  struct Case {
    const char* name;
    Scene scene;
    double over, jitter, speed, warmth;
  };
  std::vector<Case> cases;
  Scene s = periodicBlock();
  s.materials[0].soundSpeed = 10;
  for (Body& b : s.bodies) b.material = 0;
  s.numerics.tensileLimit = 1;
  cases.push_back({"sound", s, 2.9, 0.002, 0, 0});  // 0.4 of h / c; stable up to about 0.96
  s = periodicBlock();
  s.materials[0].viscosity = {10, 10};
  cases.push_back({"viscosity", s, 1.3, 0, 1e-3, 0});  // 0.8 of the limit
  s = periodicBlock();
  s.materials[0].conductivity = {100, 100};
  s.bodies[0].temperature = 300;
  s.bodies[0].temperatureGradient = {1e-6, 0, 0};
  cases.push_back({"heat", s, 1.3, 0, 0, 1});
  s = periodicBlock();
  s.materials[0].young = {1e5, 0};
  s.materials[0].law.name = "neo-hookean";
  cases.push_back({"elastic waves", s, 6, 0, 1e-3, 0});
  for (const Case& c : cases) {
    const Growth right = growthOf(c.scene, 0, 400, c.jitter, c.speed, c.warmth),
                 wrong = growthOf(c.scene, c.over * right.dt, 400, c.jitter, c.speed, c.warmth);
    measured("%s: factor %.2g in 400 steps of %.2e s (limited by %s); %.2g in steps %.1f times as long%s",
             c.name, right.factor, right.dt, right.limitedBy, wrong.factor, c.over,
             wrong.finite ? "" : ", then reported");
    EXPECT_STREQ(right.limitedBy, c.name);
    EXPECT_LT(right.factor, 1.3) << c.name;
    EXPECT_GT(wrong.factor, 100) << c.name;
  }
}

TEST(Stability, Row10TaitInStrongCompression) {
  // A liquid compressed to 1.6 times its density oscillates in a periodic box, with noise. The box keeps the
  // compression, so that only the step decides whether the energy grows.
  for (const bool naive : {true, false}) {
    Scene s = periodicBlock();
    s.domain.max = {7 * dx, 7 * dx, 7 * dx};
    s.bodies.clear();
    addBox(s, {0, 0, 0}, s.domain.max);
    s.materials[0].soundSpeed = 10;
    s.numerics.eos = EquationOfState::Tait;
    s.end = 1e9;
    Simulation run(s);
    Continuum& p = run.particles();
    const double atRest = run.w.clock.dt;
    for (std::size_t i = 0; i < p.owned; i++) p.mass[i] *= 1.6;
    for (std::size_t i = 0; i < p.owned; i++)
      for (int a = 0; a < 3; a++)
        p.velocity[i][a] = 0.01 * (hashed(3 * p.id[i] + static_cast<std::uint64_t>(a)) - 0.5);
    evaluate(run.w, run.halos(), run.tools, 0);
    reduceStep(run.w, run.halos(), run.tools, {}, {});
    const double dt = run.w.clock.dt;
    for (std::size_t i = 0; i < p.owned; i++) p.acceleration[i] = p.force[i] / p.mass[i];
    if (naive) run.w.scene.numerics.fixedStep = run.w.clock.dt = atRest;
    const double first = run.ledgerReport().now.kinetic;
    bool finite = true;
    double most = 0;
    for (int n = 0; n < 300 && finite && most < 1e6; n++) {
      finite = run.step();
      most = finite ? std::max(most, run.ledgerReport().now.kinetic / first) : never;
    }
    measured(
        "Tait at 1.6 times its density, steps %s: %.2e s (at rest %.2e), kinetic energy at most %.2g times "
        "the first",
        naive ? "as at rest" : "automatic", naive ? atRest : dt, atRest, most);
    EXPECT_NEAR(dt, atRest / (1.6 * 1.6 * 1.6), 0.05 * atRest / 4);
    if (naive) EXPECT_GT(most, 100);
    else EXPECT_LT(most, 1.5);
  }
}

TEST(Stability, Row12LightParticlesInAThickLiquid) {
  // Particles with a hundredth of the others' density, at rest with noise: in layers, in rows, single. The
  // others are fifty times as viscous. In the pairwise form the light liquid's own viscosity limits the step,
  // in the printed form the arithmetic mean of both.
  struct Case {
    ViscosityForm form;
    double over;
    bool stable;
  };
  for (const Case& c : {Case{ViscosityForm::Pairwise, 1, true},
                        {ViscosityForm::Pairwise, 1.3, false},
                        {ViscosityForm::Laplacian, 1, true},
                        {ViscosityForm::Laplacian, 26, false}}) {
    double calmest = never, wildest = 0, dt = 0;
    for (const int directions : {1, 2, 3}) {
      Scene s = periodicBlock();
      s.materials.emplace_back(s.materials[0]);
      s.materials[0].density = 1000, s.materials[1].density = 10;
      s.materials[0].viscosity = {50, 50}, s.materials[1].viscosity = {1, 1};
      s.bodies.emplace_back(s.bodies[0]);
      s.bodies[1].material = 1;
      s.bodies[1].name = "light";
      s.numerics.overlap = OverlapRule::RemoveLater;
      s.numerics.viscosity = c.form;
      s.end = 1e9;
      Simulation run(s);
      Continuum& p = run.particles();
      EXPECT_STREQ(run.w.clock.limitedBy, "viscosity");
      dt = c.over * run.w.clock.dt;
      for (std::size_t i = 0; i < p.owned; i++) {
        bool light = true;
        for (int a = 0; a < 3; a++) {
          light = light && (a >= directions || static_cast<int>(p.position[i][a] / dx) % 2 == 0);
          p.velocity[i][a] = 1e-3 * (hashed(3 * p.id[i] + static_cast<std::uint64_t>(a)) - 0.5);
        }
        if (light) p.material[i] = 1, p.mass[i] *= 0.01;
      }
      run.w.scene.numerics.fixedStep = run.w.clock.dt = dt;
      EXPECT_TRUE(run.step());
      const double first = run.ledgerReport().now.kinetic;
      bool finite = true;
      double most = 0;
      for (int n = 0; n < 400 && finite && most < 1e6; n++) {
        finite = run.step();
        most = finite ? std::max(most, run.ledgerReport().now.kinetic / first) : never;
      }
      calmest = std::min(calmest, most);
      wildest = std::max(wildest, most);
    }
    measured(
        "%s form, steps of %.2e s (%.1f times the limit): kinetic energy at most %.2g to %.2g times the "
        "first",
        c.form == ViscosityForm::Pairwise ? "pairwise" : "printed", dt, c.over, calmest, wildest);
    if (c.stable) EXPECT_LT(wildest, 1.01);
    else EXPECT_GT(calmest, 100);
  }
}

TEST(Stability, Row14FreezeMeltPingPong) {
  // a lump at its melting point, heated and cooled by 0.1 K in turn, 1000 times
  std::int64_t flips[3];
  const double swing = 0.1 * 1000;
  for (const int way : {0, 1, 2}) {
    World w;
    w.scene.materials.emplace_back();
    Material& m = w.scene.materials[0];
    m.young = {1e5, 0};
    m.heatCapacity = {1000, 1000};
    m.solidus = m.liquidus = 300;
    m.latentHeat = 1e4;
    m.hysteresis = way == 2 ? 0.2 : 0;
    if (way == 0) w.scene.numerics.heat = HeatModel::Paper;
    w.scene.bodies.emplace_back();
    w.modules.heat = w.modules.melting = true;
    Continuum& p = w.particles;
    for (AnyColumn* c : p.columns) p.activate(*c);
    p.resize(1, 0);
    p.mass[0] = 1;
    p.solidIndex[0] = noSolid;
    p.temperature[0] = 299.95;
    // half of the latent heat; at the edge of the hysteresis
    p.enthalpy[0] = way == 0 ? 299.95 * 1000 : way == 1 ? 0.5 * 1e4 : 0.81 * 1e4;
    setPhase(w.scene, w.modules, p, 0, 1);
    for (int n = 0; n < 1000; n++) {
      p.heatFlow[0] = n % 2 ? -swing : swing;
      updateHeat(heatView(w), 1);
      changePhase(w.scene, w.particles, w.counters);
    }
    flips[way] = w.counters.melted + w.counters.frozen;
  }
  measured(
      "phase changes in 1000 swings of 0.1 K: %lld by temperature alone, %lld with latent heat, %lld with "
      "hysteresis too",
      static_cast<long long>(flips[0]), static_cast<long long>(flips[1]), static_cast<long long>(flips[2]));
  EXPECT_EQ(flips[0], 1000);
  EXPECT_EQ(flips[1], 0);
  EXPECT_LE(flips[2], 1);
}

}  // namespace thaw::test
