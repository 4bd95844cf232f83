// SPDX-License-Identifier: Apache-2.0
// Surface tension by curvature (core/flow/curvature/).
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/domain/extensions.hpp"
#include "tests/support/simulation.hpp"

namespace thaw {
namespace {

using namespace thaw::test;
using std::numbers::pi;

Scene withCurvature(Scene s) {
  s.numerics.tension = TensionForm::Curvature;
  s.numerics.density = DensityForm::Continuity;
  s.numerics.shifting = 0.2;
  s.numerics.tensileLimit = 1;
  return s;
}

Material oil() {
  Material m;
  m.density = 1;
  m.viscosity = {0.5, 0.5};
  m.surfaceTension = 1;
  return m;
}

Scene drop(double spacing) {
  Scene s = emptyScene(spacing, {-2, -2, -2}, {2, 2, 2});
  s.materials.push_back(oil());
  s.bodies.emplace_back();
  s.bodies[0].name = "drop";
  s.bodies[0].shape.kind = ShapeKind::Sphere;
  s.bodies[0].shape.radius = 1;
  s.bodies[0].packing = Packing::Relaxed;
  return withCurvature(s);
}

Vec3d tensionOf(const World& w, std::size_t i) {
  const double* f = tensionForceOf(w.particles)->row(i);
  return {f[0], f[1], f[2]};
}

// The work of the force on a swelling ball is that of the surface, d(4 pi R^2 gamma) = 8 pi R gamma dR.
TEST(SurfaceCurvature, ABallHasLaplacesPressure) {
  const Simulation run(drop(0.125));
  double inwards = 0, tangential = 0;
  Vec3d total{};
  for (std::size_t i = 0; i < run.w.particles.owned; i++) {
    const Vec3d f = tensionOf(run.w, i),
                e = run.w.particles.position[i] / length(run.w.particles.position[i]);
    inwards -= dot(f, e);
    tangential += length(f - e * dot(f, e));
    total += f;
  }
  EXPECT_NEAR(inwards / (8 * pi), 1, 0.05);
  EXPECT_LT(tangential / inwards, 0.1);
  EXPECT_LT(length(total) / inwards, 0.01);
}

// A flat layer whose tension falls along x: the force along the surface is the slope of the tension.
TEST(SurfaceCurvature, AFlatLayerFeelsTheSlopeOfTheTension) {
  Scene s = emptyScene(0.1, {0, 0, 0}, {3, 0.6, 2});
  s.domain.side[0] = {Side::Wall, Side::Wall};
  s.domain.side[1] = {Side::Periodic, Side::Periodic};
  s.domain.side[2] = {Side::Wall, Side::Open};
  Material m = oil();
  m.surfaceTension = 1;
  m.surfaceTensionTable = {{300, 1}, {330, 0.4}};
  m.conductivity = {0.1, 0.1};
  s.materials.push_back(m);
  Body& b = addBox(s, {0, 0, 0}, {3, 0.6, 1});
  b.temperature = 315;
  b.temperatureGradient = {10, 0, 0};
  const Simulation run(withCurvature(s));
  double along = 0, largest = 0;
  for (std::size_t i = 0; i < run.w.particles.owned; i++) {
    const Vec3d f = tensionOf(run.w, i), &x = run.w.particles.position[i];
    if (x.x < 0.5 || x.x > 2.5) continue;
    along += f.x;
    largest = std::max(largest, std::abs(f.y));
  }
  EXPECT_NEAR(along, -0.2 * 2 * 0.6, 0.05 * 0.2 * 2 * 0.6);
  EXPECT_LT(largest, 1e-6);
}

// Work and impulse of the force are recorded, on a floor with a contact angle, too.
TEST(SurfaceCurvature, TheLedgerCloses) {
  Scene s = drop(0.2);
  s.domain.side[2] = {Side::Wall, Side::Open};
  s.materials[0].contactAngle = pi / 3;
  s.bodies[0].shape.move = {0, 0, -0.9};
  s.end = 0.3;
  Simulation run(s);
  ASSERT_TRUE(run.run());
  const LedgerReport r = run.ledgerReport();
  EXPECT_GT(std::abs(r.wallWork), 0.01);
  EXPECT_LT(std::abs(r.energyResidual), 0.01 * std::abs(r.wallWork));
  EXPECT_LT(length(r.momentumResidual), 1e-10 * r.now.mass);
}

// Without tension by curvature, its field does not exist.
TEST(SurfaceCurvature, OtherScenesHaveNoField) {
  Scene s = drop(0.25);
  s.materials[0].surfaceTension = 0;
  const Simulation run(s);
  EXPECT_EQ(tensionForceOf(run.w.particles), nullptr);
}

}  // namespace
}  // namespace thaw
