// SPDX-License-Identifier: Apache-2.0
// Failures of viscosity and surface tension in liquids: rows of docs/validation/stability.md. Each test
// provokes the failure, shows a naive implementation fail where that is cheap, and checks the stated
// behaviour of thaw.
#include "core/kernels/kernels.hpp"
#include "tests/support/free_liquid.hpp"
#include "tests/support/hashed.hpp"
#include "tests/support/measured.hpp"

namespace thaw::test {
namespace {

constexpr double dx = liquidSpacing;

Body& addBall(Scene& s, double radius, const Vec3d& centre = {}) {
  s.bodies.emplace_back();
  s.bodies.back().name = "ball" + std::to_string(s.bodies.size());
  s.bodies.back().shape.kind = ShapeKind::Sphere;
  s.bodies.back().shape.radius = radius;
  s.bodies.back().shape.move = centre;
  return s.bodies.back();
}

}  // namespace

TEST(Stability, Row11ViscosityRatio) {
  // Two layers with viscosities 1 : 10^4 in the velocity field of their common shear flow. Measures the
  // ratio of the stress across the interface to that of the flow.
  const double mu[2] = {1, 1e4}, rate = 10;  // Pa s, Pa: tau = mu du/dz
  Scene s = columnScene(dx, 0, 16 * dx);
  s.materials.emplace_back(s.materials[0]);
  s.materials[1].name = "thick";
  for (std::size_t k = 0; k < 2; k++)
    s.materials[k].viscosity = {mu[k], mu[k]}, s.materials[k].soundSpeed = 1;
  s.numerics.precision = Precision::Double;
  addBox(s, {0, 0, 0}, {6 * dx, 6 * dx, 8 * dx});
  addBox(s, {0, 0, 8 * dx}, {6 * dx, 6 * dx, 16 * dx}).material = 1;
  Simulation run(s);
  Continuum& p = run.particles();
  for (std::size_t i = 0; i < p.owned; i++) {
    const double z = p.position[i].z - 8 * dx;
    p.velocity[i] = {rate * z / (z < 0 ? mu[0] : mu[1]), 0, 0};
  }
  run.w.clock.dt = 0;
  evaluate(run.w, run.halos(), run.tools, 0);
  double upper = 0;
  for (std::size_t i = 0; i < p.owned; i++)
    if (p.material[i] == 1) upper -= p.force[i].x;
  const double stress = upper / (36 * dx * dx) / rate;
  // the same pairs with the arithmetic mean
  const double arithmetic = stress * (mu[0] + mu[1]) * (mu[0] + mu[1]) / (4 * mu[0] * mu[1]);
  reduceStep(run.w, run.halos(), run.tools, {}, {});
  measured(
      "stress across the interface over that of the flow: %.0f with the arithmetic mean, %.2f; the step is "
      "%.1e s (%s), 10^4 times shorter than for the thin layer alone",
      arithmetic, stress, run.w.clock.dt, run.w.clock.limitedBy);
  EXPECT_GT(arithmetic, 1000);
  EXPECT_NEAR(stress, 1, 0.35);
}

TEST(Stability, Row11ViscosityRatioImplicit) {
  // The same layers in shear. The implicit solver takes acoustic steps, and its work per step is bounded.
  double dt[2][2], iterations = 0, fastest = 0;
  std::int64_t unfinished = 0;
  for (const bool implicit : {false, true})
    for (const bool thick : {false, true}) {
      Scene s = columnScene(dx, 0, 16 * dx);
      s.materials.emplace_back(s.materials[0]);
      s.materials[1].name = "thick";
      for (Material& m : s.materials) m.viscosity = {1, 1}, m.soundSpeed = 10;
      if (thick) s.materials[1].viscosity = {1e4, 1e4};
      s.numerics.viscositySolver = implicit ? ViscositySolver::Implicit : ViscositySolver::Explicit;
      addBox(s, {0, 0, 0}, {6 * dx, 6 * dx, 8 * dx});
      addBox(s, {0, 0, 8 * dx}, {6 * dx, 6 * dx, 16 * dx}).material = 1;
      s.end = 1;
      Simulation run(s);
      Continuum& p = run.particles();
      for (std::size_t i = 0; i < p.owned; i++)
        for (int a = 0; a < 3; a++)
          p.velocity[i][a] = 0.1 * (hashed(3 * p.id[i] + static_cast<std::uint64_t>(a)) - 0.5) +
                             (a == 0 && p.material[i] == 0 ? 0.1 : 0);
      run.shortest = never;
      for (int n = 0; n < 100; n++) ASSERT_TRUE(run.step());
      dt[implicit][thick] = run.shortest;
      if (!implicit || !thick) continue;
      iterations = static_cast<double>(run.w.counters.viscousIterations) / 100;
      unfinished = run.w.counters.viscousUnfinished;
      for (std::size_t i = 0; i < p.owned; i++) fastest = std::max(fastest, length(p.velocity[i]));
    }
  measured(
      "step with viscosities 1 : 10^4 over that without the thick liquid: %.1e explicit, %.2f implicit (%.1e "
      "s; %.1f iterations a step, %lld unfinished)",
      dt[0][1] / dt[0][0], dt[1][1] / dt[1][0], dt[1][1], iterations, static_cast<long long>(unfinished));
  EXPECT_LT(dt[0][1], 0.01 * dt[1][1]);
  EXPECT_GT(dt[1][1], 0.8 * dt[1][0]);
  EXPECT_LT(iterations, 100);
  EXPECT_EQ(unfinished, 0);
  EXPECT_LT(fastest, 0.25);
}

TEST(Stability, Row24TensionOfInnerAndLonelyParticles) {
  // The printed colour field has no direction where its gradient n vanishes. thaw leaves out the force where
  // |n| h < 0.3, and its own form needs no normal.
  for (const TensionForm form : {TensionForm::ColourField, TensionForm::Pairwise}) {
    Scene s = freeLiquid();
    s.materials[0].surfaceTension = 0.07;
    s.materials[0].soundSpeed = 1e-3;  // negligible pressure
    s.numerics.tension = form;
    addBox(s, {-5 * dx, -5 * dx, -5 * dx}, {5 * dx, 5 * dx, 5 * dx});
    addBox(s, {20 * dx, 0, 0}, {21 * dx, dx, dx});  // one particle
    Simulation run(s);
    Continuum& p = run.particles();
    for (std::size_t i = 0; i < p.owned; i++)
      for (int a = 0; a < 3; a++)
        p.position[i][a] += 0.02 * dx * (hashed(3 * p.id[i] + static_cast<std::uint64_t>(a)) - 0.5);
    evaluate(run.w, run.halos(), run.tools, 0);
    double inner = 0, surface = 0, lonely = -1, noise = 0;
    for (std::size_t i = 0; i < p.owned; i++) {
      const double f = length(p.force[i]),
                   far = std::max(
                       {std::abs(p.position[i].x), std::abs(p.position[i].y), std::abs(p.position[i].z)});
      if (far > 15 * dx) lonely = f;
      else if (far < 2.2 * dx) {
        inner = std::max(inner, f);
        // sigma lap(c) n / |n| without a threshold has its full size in a random direction
        double laplacian = 0;
        for (std::size_t j = 0; j < p.owned; j++) {
          const Vec3d q = (p.position[i] - p.position[j]) / (2 * dx);
          const double q2 = dot(q, q), u = std::max(0.0, 1 - q2);
          laplacian += 945 / (32 * std::numbers::pi) / 8 * u * (7 * q2 - 3) / (4 * dx * dx);
        }
        noise = std::max(noise, 0.07 * std::abs(laplacian) * dx * dx * dx);
      } else surface = std::max(surface, f);
    }
    if (form == TensionForm::ColourField)
      measured(
          "printed form: force on inner particles over the largest of the surface: %.2f without a threshold, "
          "%.1e; on a lonely one %.1e N",
          noise / surface, inner / surface, lonely);
    else
      measured("pairwise form: on inner particles %.1e of the largest, on a lonely one %.1e N",
               inner / surface, lonely);
    EXPECT_EQ(lonely, 0);
    EXPECT_LT(inner, 0.1 * surface);
    EXPECT_GT(surface, 0);
  }
}

TEST(Stability, Row31SpinningViscousDrop) {
  // loss rate of the spin, times R^2 / nu
  double rate[2];
  const double R = 6 * dx, nu = 0.01;
  for (const bool naive : {true, false}) {
    Scene s = freeLiquid();
    s.numerics.precision = Precision::Double;
    s.numerics.viscosity = naive ? ViscosityForm::Laplacian : ViscosityForm::Pairwise;
    s.materials[0].viscosity = {1000 * nu, 1000 * nu};
    s.materials[0].soundSpeed = 2;
    addBall(s, R).spin = {0, 0, 0.5};
    s.end = 0.02 * R * R / nu;
    Simulation run(s);
    const double before = run.ledgerReport().now.angularMomentum.z;
    EXPECT_TRUE(run.run());
    rate[!naive] = (1 - run.ledgerReport().now.angularMomentum.z / before) / 0.02;
  }
  measured("spin lost at %.1f nu/R^2 with the plain Laplacian, at %.1e", rate[0], rate[1]);
  EXPECT_GT(rate[0], 2);
  EXPECT_LT(std::abs(rate[1]), 1e-9);
}

TEST(Stability, Row32DropThatPropelsItself) {
  // a pear-shaped drop: velocity of its centre of mass without external forces
  double speed[2];
  for (const bool naive : {true, false}) {
    Scene s = freeLiquid();
    s.numerics.precision = Precision::Double;
    s.numerics.overlap = OverlapRule::RemoveLater;
    s.numerics.tension = naive ? TensionForm::ColourField : TensionForm::Pairwise;
    s.materials[0].surfaceTension = 0.5;
    s.materials[0].viscosity = {1, 1};
    addBall(s, 5 * dx);
    addBall(s, 2.5 * dx, {6.2 * dx, 0.3 * dx, 0});
    s.end = 0.1;
    Simulation run(s);
    EXPECT_TRUE(run.run());
    const LedgerReport r = run.ledgerReport();
    speed[!naive] = length(r.now.momentum) / r.now.mass;
  }
  measured("speed of the centre of mass after 0.1 s: %.1e m/s with the colour field, %.1e", speed[0],
           speed[1]);
  EXPECT_GT(speed[0], 1e-3);
  EXPECT_LT(speed[1], 1e-12);
}

}  // namespace thaw::test
