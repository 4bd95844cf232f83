// SPDX-License-Identifier: Apache-2.0
// Convection and conduction of thin bodies and at edges, where particles lack neighbours.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/simulation.hpp"

namespace thaw::test {
namespace {

constexpr double dx = 0.01;
using std::numbers::pi;

Scene solidScene(double size) {
  Scene s = emptyScene(dx, {-size, -size, -size}, {size, size, size});
  s.numerics.precision = Precision::Double;
  s.materials.emplace_back();
  s.materials[0].name = "stuff";
  s.materials[0].young = {1, 0};
  s.materials[0].conductivity = {1000, 1000};
  return s;
}

/// Area (spacing^2) through which a body convects in its first steps.
double convectingArea(Scene s) {
  Material& m = s.materials[0];
  m.convection = 10;
  s.domain.ambient = 300;
  s.bodies[0].temperature = 400;
  s.end = 1e-6;
  Simulation run(s);
  EXPECT_TRUE(run.run());
  return run.ledgerReport().heatIn / (m.convection * -100 * run.w.clock.time * dx * dx);
}

double boxArea(int a, int b, int c) {
  Scene s = solidScene(0.3);
  const Vec3d half = Vec3d{a * dx, b * dx, c * dx} * 0.5;
  addBox(s, -1.0 * half, half);
  return convectingArea(s);
}

double ballArea(double radius, Packing packing) {
  Scene s = solidScene(0.3);
  if (packing == Packing::Relaxed) s.materials[0].young = {}, s.materials[0].soundSpeed = 0.1;
  Body& ball = s.bodies.emplace_back();
  ball.name = "ball";
  ball.shape.kind = ShapeKind::Sphere;
  ball.shape.radius = radius * dx;
  ball.packing = packing;
  return convectingArea(s);
}

/// Conductivity along a rod of a x a spacings, relative to that of its material, from the decay of the
/// slowest mode.
double rodConductivity(int a) {
  constexpr int length = 16;
  Scene s = solidScene(0.15);
  const Vec3d half = Vec3d{length * dx, a * dx, a * dx} * 0.5;
  Body& rod = addBox(s, -1.0 * half, half);
  rod.temperatureGradient = {100, 0, 0};
  const double alpha = 1000 / (1000 * 1000.0), rate = alpha * std::pow(pi / (length * dx), 2);
  const auto amplitude = [&](double end) {
    s.end = end;
    Simulation run(s);
    EXPECT_TRUE(run.run());
    const Continuum& p = run.particles();
    double sum = 0;
    for (std::size_t i = 0; i < p.owned; i++)
      sum += p.temperature[i] * std::sin(pi * p.position[i].x / (length * dx));
    return sum;
  };
  const double from = 0.2 / rate, to = 1 / rate;
  return std::log(amplitude(from) / amplitude(to)) / (rate * (to - from));
}

}  // namespace

TEST(FreeSurfaceHeat, BoxesConvectOverTheirArea) {
  for (const int n : {1, 2, 3, 5, 10, 15}) EXPECT_NEAR(boxArea(n, n, n) / (6.0 * n * n), 1, 0.03) << n;
  for (const int layers : {1, 2, 3, 4})
    EXPECT_NEAR(boxArea(12, 12, layers) / (288 + 48.0 * layers), 1, 0.03) << layers;
  for (const int n : {1, 2, 4}) EXPECT_NEAR(boxArea(n, n, 16) / (2.0 * n * n + 64 * n), 1, 0.03) << n;
}

// The number of particles of a ball scatters around its volume divided by that of a particle.
TEST(FreeSurfaceHeat, BallsConvectOverTheirArea) {
  for (const double r : {4.0, 6.0, 8.0, 10.0}) {
    const double exact = 4 * pi * r * r;
    const double share = r < 8 ? 0.05 : 0.03;
    EXPECT_NEAR(ballArea(r, Packing::Relaxed) / exact, 1, share) << r;
    EXPECT_NEAR(ballArea(r, Packing::Lattice) / exact, 1, r < 6 ? 0.12 : share) << r;
  }
}

TEST(FreeSurfaceHeat, CornersOfWallsCoverFaces) {
  constexpr int n = 6;
  for (const int walls : {1, 2, 3}) {
    Scene s = solidScene(0.3);
    for (int a = 0; a < walls; a++) s.domain.min[a] = 0, s.domain.side[a] = {Side::Wall, Side::Wall};
    addBox(s, {0, 0, 0}, {n * dx, n * dx, n * dx});
    EXPECT_NEAR(convectingArea(s) / (n * n), 6 - walls, 0.03) << walls;
  }
}

TEST(FreeSurfaceHeat, RodsConductAlongTheirSurface) {
  for (const int a : {1, 2, 3, 4, 8}) EXPECT_NEAR(rodConductivity(a), 1, 0.02) << a;
}

}  // namespace thaw::test
