// SPDX-License-Identifier: Apache-2.0
// Free vibration, waves and stability of whole bodies.
#include <gtest/gtest.h>

#include <cstdio>
#include <numbers>

#include "tests/support/solid_body.hpp"

using namespace thaw;
using namespace thaw::test;

namespace {

struct Moving {
  std::unique_ptr<SolidBody> body;
  std::vector<Vec3d> velocity;
};

double kinetic(const Moving& m) {
  double e = 0;
  for (std::size_t s = 0; s < m.velocity.size(); s++)
    e += 0.5 * m.body->mass[s] * dot(m.velocity[s], m.velocity[s]);
  return e;
}
/// Velocity Verlet. Requires: the forces are current.
void advance(Moving& m, double dt) {
  SolidBody& b = *m.body;
  for (std::size_t s = 0; s < m.velocity.size(); s++) {
    m.velocity[s] += (0.5 * dt / b.mass[s]) * b.solids.force[s];
    b.solids.position[s] += dt * m.velocity[s];
  }
  b.step.dt = dt;
  computeForces(b);
  for (std::size_t s = 0; s < m.velocity.size(); s++)
    m.velocity[s] += (0.5 * dt / b.mass[s]) * b.solids.force[s];
}

/// Largest deviation of the total energy over a time, relative to the initial kinetic energy.
double energyError(const char* law, double dt, Precision precision) {
  const auto points = lattice({8, 4, 4}, 0.1, 0.1);
  Material m = elasticMaterial(1e5, 0.3);
  m.law.name = law;
  m.hourglass = 0.5;
  BodyOptions options;
  options.precision = precision;
  Moving b{makeBody(points, {m}, options), {}};
  for (const Vec3d& x : points) b.velocity.push_back({0.3 * std::sin(3 * x.x), 0.4 * x.x - 0.1, 0.3 * x.y});
  computeForces(*b.body);
  const double first = kinetic(b) + totalEnergy(*b.body);
  double worst = 0;
  for (int n = 0; n * dt < 0.6; n++) {
    advance(b, dt);
    worst = std::max(worst, std::abs(kinetic(b) + totalEnergy(*b.body) - first));
  }
  return worst / first;
}

}  // namespace

TEST(ElasticBody, EnergyErrorOfFreeVibrationIsOfSecondOrder) {
  for (const char* const law : {"green", "neo-hookean", "corotated"}) {
    const double coarse = energyError(law, 2e-3, Precision::Double),
                 fine = energyError(law, 1e-3, Precision::Double);
    std::printf("%s: energy error %.2e at dt, %.2e at dt/2\n", law, coarse, fine);
    EXPECT_LT(coarse, 5e-3) << law;
    EXPECT_LT(fine, 0.3 * coarse) << law;
  }
  const double single = energyError("green", 5e-4, Precision::Single);
  std::printf("single precision: energy error %.2e at dt/4\n", single);
  EXPECT_LT(single, 5e-4);
}

TEST(ElasticBody, SpeedOfPressureWavesIsExact) {
  // A standing wave in a periodic block. MLS is slow by 1.6 % at 20 spacings per wavelength for h <= 2 dx
  // (docs/validation/accuracy.md).
  const int n = 20;
  const auto points = lattice({n, 4, 4}, 0.1);
  BodyOptions options;
  options.period = {0.1 * n, 0.4, 0.4};
  Moving b{makeBody(points, {elasticMaterial(1e6, 0.3)}, options), {}};
  const double k = 2 * std::numbers::pi / (0.1 * n), speed = std::sqrt(1e6 * 0.7 / (1000 * 1.3 * 0.4));
  for (std::size_t s = 0; s < points.size(); s++)
    b.body->solids.position[s].x += 1e-4 * std::cos(k * points[s].x);
  b.velocity.resize(points.size());
  computeForces(*b.body);
  const double dt = 2e-4;
  // half a period: the displacement of particle 0 reverses
  double last = 1, turned = 0;
  for (int step = 1; turned == 0 && step < 1000; step++) {
    advance(b, dt);
    const double v = b.velocity[0].x;
    if (last < 0 && v >= 0) turned = (step - v / (v - last)) * dt;
    last = v;
  }
  const double measured = 0.1 * n / (2 * turned);
  std::printf("P wave %.4f of the exact speed\n", measured / speed);
  EXPECT_NEAR(measured / speed, 0.984, 0.006);
}

TEST(ElasticBody, CheckerboardHasEnergy) {
  // docs/validation/stability.md, row 2: without hourglass control the checkerboard mode has no energy inside
  const auto points = lattice({8, 8, 8}, 0.1);
  for (const double alpha : {0.0, 0.1}) {
    Material m = elasticMaterial();
    m.hourglass = alpha;
    BodyOptions options;
    options.period = {0.8, 0.8, 0.8};
    const auto b = makeBody(points, {m}, options);
    for (std::size_t s = 0; s < points.size(); s++)
      b->solids.position[s].x += ((s % 8 + s / 8 % 8 + s / 64) % 2 ? 1 : -1) * 1e-3;
    computeForces(*b);
    if (alpha == 0) EXPECT_LT(forceScale(*b), 1e-8);
    else EXPECT_GT(forceScale(*b), 10);
  }
}

TEST(ElasticBody, StepLimitIsStableAndTight) {
  const auto points = lattice({6, 6, 6}, 0.1, 0.2);
  for (const double support : {1.6, 2.0})
    for (const double factor : {1.0, 6.0}) {
      Material m = elasticMaterial(1e5, 0.3);
      m.hourglass = 1;
      BodyOptions options;
      options.support = support;
      Moving b{makeBody(points, {m}, options), {}};
      for (std::size_t s = 0; s < points.size(); s++) b.velocity.push_back(0.05 * noise3(s, 8));
      computeForces(*b.body);
      const double first = kinetic(b), dt = factor * elasticStepLimit(b.body->scene);
      double last = first;
      for (int n = 0; n < 400 && last < 10 * first; n++) {
        advance(b, dt);
        last = kinetic(b) + totalEnergy(*b.body);
      }
      if (factor == 1.0) EXPECT_LT(last, 1.05 * first);
      else EXPECT_FALSE(last < 2 * first);
    }
}

// Frozen liquid is no lattice: close pairs, holes, thin crusts. The step follows the worst neighbourhood.
TEST(ElasticBody, StepLimitIsStableForUnevenNeighbourhoods) {
  std::vector<std::vector<Vec3d>> bodies{
      lattice({6, 6, 6}, 0.1, 0.35), lattice({9, 9, 1}, 0.1, 0.25), {}, {}, {{0, 0, 0}, {0.04, 0, 0}}};
  const auto dust = lattice({8, 8, 8}, 0.1, 0.3);
  for (std::size_t k = 0; k < dust.size(); k++)
    if (noise(k, 5) < -0.6) bodies[2].push_back(dust[k]);
  for (std::size_t k = 0; bodies[3].size() < 200; k++) {
    const Vec3d x = 0.35 * noise3(k, 6);
    bool far = true;
    for (const Vec3d& y : bodies[3]) far = far && length(x - y) > 0.05;
    if (far) bodies[3].push_back(x);
  }
  for (const auto& points : bodies)
    for (const double support : {1.6, 2.0}) {
      Material m = elasticMaterial(1e5, 0.3);
      m.hourglass = 1;
      BodyOptions options;
      options.support = support;
      Moving b{makeBody(points, {m}, options), {}};
      for (std::size_t s = 0; s < points.size(); s++) b.velocity.push_back(0.001 * noise3(s, 8));
      computeForces(*b.body);
      const double first = kinetic(b),
                   dt = elasticStepLimit(b.body->scene, 1, largestStrainBound(b.body->work, b.body->solids));
      double last = first;
      for (int n = 0; n < 1000 && last < 10 * first; n++) {
        advance(b, dt);
        last = kinetic(b) + totalEnergy(*b.body);
      }
      // bounded: the leap-frog energy oscillates by 1 / (1 - (omega dt)^2 / 4) with omega dt up to 1.3
      EXPECT_LT(last, 1.75 * first) << points.size() << " points, support " << support;
    }
}

TEST(ElasticBody, LatticeGripBoundsLattices) {
  for (const double support : {1.5, 1.75, 2.0, 2.5, 3.0}) {
    BodyOptions options;
    options.support = support;
    const auto b = makeBody(lattice({7, 7, 7}, 0.1), {elasticMaterial()}, options);
    EXPECT_LT(0.1 * largestStrainBound(b->work, b->solids), 1.01 * latticeStrainBound) << support;
  }
}

TEST(ElasticBody, DampingRecordsItsDissipation) {
  const auto points = lattice({5, 4, 4}, 0.1, 0.1);
  Material m = elasticMaterial(1e5, 0.3);
  m.damping = 20;
  Moving b{makeBody(points, {m}), {}};
  for (std::size_t s = 0; s < points.size(); s++) b.velocity.push_back(0.1 * noise3(s, 8));
  b.body->step.dt = 1e-4;
  computeForces(*b.body);
  const double first = kinetic(b);
  double lost = 0;
  for (int n = 0; n < 500; n++) {
    std::copy(b.velocity.begin(), b.velocity.end(), b.body->solids.velocity.data());
    advance(b, 1e-4);
    for (std::size_t s = 0; s < points.size(); s++) lost += b.body->solids.dissipated[s];
  }
  const double last = kinetic(b) + totalEnergy(*b.body);
  EXPECT_LT(last, 0.8 * first);
  EXPECT_NEAR(lost, first - last, 0.02 * first);
}
