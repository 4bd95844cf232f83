// SPDX-License-Identifier: Apache-2.0
// Surface tension by curvature (core/flow/curvature/).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/terms/extensions.hpp"
#include "tests/support/simulation.hpp"

namespace thaw {
namespace {

using namespace thaw::test;
using std::numbers::pi;

Scene withCurvature(Scene s) {
  s.numerics.tension = TensionForm::Curvature;
  carryDensity(s, 0.2);
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

/// A drop whose tension falls by 0.25 N/m per metre along x, while its temperature rises.
Scene marangoniDrop(double spacing) {
  Scene s = drop(spacing);
  Material& m = s.materials[0];
  m.surfaceTension = 1.5;
  m.surfaceTensionTable = {{300, 2}, {340, 1}};
  m.conductivity = {0.01, 0.01};
  s.bodies[0].temperature = 320;
  s.bodies[0].temperatureGradient = {10, 0, 0};
  return s;
}

// The slope of the tension over the surface of a ball adds up to 8 pi R^2 / 3 times the slope in space.
TEST(SurfaceCurvature, SlopesOfTheTensionActOnTheSurfaceOutsideOfTheParticles) {
  const Simulation run(marangoniDrop(0.125));
  double along = 0;
  for (std::size_t i = 0; i < run.w.particles.owned; i++) {
    const Vec3d f = tensionOf(run.w, i),
                e = run.w.particles.position[i] / length(run.w.particles.position[i]);
    along += (f - e * dot(f, e)).x;
  }
  EXPECT_NEAR(along / (-0.25 * 8 * pi / 3), 1, 0.1);
}

// The tension of a free drop has no net force.
TEST(SurfaceCurvature, FreeDropsKeepTheirMomentum) {
  Scene s = marangoniDrop(0.2);
  s.bodies.push_back(s.bodies[0]);
  s.bodies[0].shape.move = {-1, 0, 0};
  s.bodies[1].name = "small";
  s.bodies[1].shape.move = {1, 0, 0};
  s.bodies[1].shape.radius = 0.6;
  s.end = 0.2;
  Simulation run(s);
  ASSERT_TRUE(run.run());
  for (const bool left : {true, false}) {
    Vec3d total{};
    double size = 0;
    for (std::size_t i = 0; i < run.w.particles.owned; i++)
      if (const Vec3d f = tensionOf(run.w, i); left == (run.w.particles.position[i].x < 0.2))
        total += f, size += length(f);
    EXPECT_GT(size, 1);
    EXPECT_LT(length(total) / size, 1e-10);
  }
  EXPECT_LT(length(run.ledgerReport().now.momentum), 1e-10);
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
  s.numerics.cflSound = s.numerics.cflViscous = 0.2;  // the drag of the wall has an error of first order
  s.end = 0.3;
  Simulation run(s);
  ASSERT_TRUE(run.run());
  const LedgerReport r = run.ledgerReport();
  EXPECT_GT(std::abs(r.wallWork), 0.01);
  EXPECT_LT(std::abs(r.energyResidual), 0.01 * std::abs(r.wallWork));
  EXPECT_LT(length(r.momentumResidual), 1e-10 * r.now.mass);
}

Scene latticeBox(int x, int y, int z) {
  Scene s = emptyScene(0.1, {-2, -2, -2}, {2, 2, 2});
  s.materials.push_back(oil());
  const Vec3d half{0.05 * x, 0.05 * y, 0.05 * z};
  addBox(s, half * -1.0, half);
  return withCurvature(s);
}

// Both faces of a film pull on its edge.
TEST(SurfaceCurvature, AFilmOfOneLayerHasTheTensionOfBothFaces) {
  const Simulation run(latticeBox(10, 10, 1));
  double pull = 0;
  for (std::size_t i = 0; i < run.w.particles.owned; i++)
    if (run.w.particles.position[i].x > 0) pull -= tensionOf(run.w, i).x;
  EXPECT_NEAR(pull, 2 * 1.0, 0.1 * 2);
}

/// Force (N) down on a particle above another one on a floor with this contact angle (rad).
double pullAboveAFilm(double contactAngle) {
  Scene s = emptyScene(0.1, {-2, -2, 0}, {2, 2, 2});
  s.domain.side[2] = {Side::Wall, Side::Open};
  s.materials.push_back(oil());
  s.materials[0].contactAngle = contactAngle;
  addBox(s, {-0.05, -0.05, 0}, {0.05, 0.05, 0.1});
  addBox(s, {-0.05, -0.05, 0.1}, {0.05, 0.05, 0.2});
  const Simulation run(withCurvature(s));
  double pull = 0;
  for (std::size_t i = 0; i < run.w.particles.owned; i++)
    if (run.w.particles.position[i].z > 0.1) pull -= tensionOf(run.w, i).z;
  return pull;
}

// Liquid above a film that wets a wall is too far from the wall to lose cohesion.
TEST(SurfaceCurvature, LiquidAboveAFilmIsHeldAtAnyContactAngle) {
  const double dry = pullAboveAFilm(pi);
  EXPECT_GT(dry, 0);
  EXPECT_NEAR(pullAboveAFilm(pi / 6) / dry, 1, 0.1);
}

// The wedge of gas below a drop at 150 degrees is narrower than the kernel. A drop that begins with this
// angle sinks by 13 % if the wedge counts as filled, since it then spreads. Otherwise it sinks by 9 %.
TEST(SurfaceCurvature, ADropOverhangsItsWall) {
  Scene s = drop(0.125);
  s.domain.min.z = 0;
  s.domain.side[2] = {Side::Wall, Side::Open};
  s.materials[0].viscosity = {0.2, 0.2};
  s.materials[0].contactAngle = 150 * pi / 180;
  Shape ball = s.bodies[0].shape, box;
  ball.move = {0, 0, std::sqrt(0.75)};
  box.kind = ShapeKind::Box;
  box.size = {3, 3, 3};
  box.move = {0, 0, 1.5};
  s.bodies[0].shape = {};
  s.bodies[0].shape.kind = ShapeKind::Intersection;
  s.bodies[0].shape.parts = {ball, box};
  s.end = 1.25;
  Simulation run(s);
  const auto height = [&] {
    double sum = 0;
    for (std::size_t i = 0; i < run.w.particles.owned; i++) sum += run.w.particles.position[i].z;
    return sum / static_cast<double>(run.w.particles.owned);
  };
  const double start = height();
  ASSERT_TRUE(run.run());
  EXPECT_GT(height() / start, 0.89);
}

// A drop of few particles has large errors of the curvature, but does not push itself.
TEST(SurfaceCurvature, DropsOfFewParticlesStayTogetherAndInPlace) {
  for (const int side : {2, 3, 4}) {
    Scene s = latticeBox(side, side, side);
    s.materials[0].viscosity = {0.01, 0.01};
    s.bodies[0].packing = Packing::Relaxed;
    s.end = 1;
    Simulation run(s);
    ASSERT_TRUE(run.run());
    const Continuum& p = run.w.particles;
    Vec3d momentum{};
    double farthest = 0, mass = 0;
    for (std::size_t i = 0; i < p.owned; i++) {
      momentum += p.velocity[i] * p.mass[i], mass += p.mass[i];
      farthest = std::max(farthest, length(p.position[i]));
    }
    EXPECT_LT(length(momentum) / mass, 0.05) << side;  // the capillary speed is 3
    EXPECT_LT(farthest, 0.12 * side) << side;
  }
}

// Particles in the concave surface above the rim of a spreading drop must not be ejected.
TEST(SurfaceCurvature, ASpreadingDropKeepsItsParticles) {
  Scene s = emptyScene(0.31e-3, {-9e-3, -9e-3, 0}, {9e-3, 9e-3, 7e-3});
  s.domain.side[2] = {Side::Wall, Side::Open};
  s.domain.gravity = {0, 0, -9.81};
  Material m;
  m.density = 1000;
  m.viscosity = {0.05, 0.05};
  m.surfaceTension = 0.072;
  m.contactAngle = pi / 6;
  s.materials.push_back(m);
  s.bodies.emplace_back();
  s.bodies[0].name = "drop";
  s.bodies[0].shape.kind = ShapeKind::Sphere;
  s.bodies[0].shape.radius = 2.5e-3;
  s.bodies[0].shape.move = {0, 0, 2.68e-3};
  s.end = 0.012;
  Scene with = withCurvature(s);
  with.numerics.shifting = 0.07;
  Simulation run(with);
  ASSERT_TRUE(run.run());
  const Continuum& p = run.w.particles;
  const double near = 1.5 * s.spacing;
  for (std::size_t i = 0; i < p.owned; i++) {
    int neighbours = 0;
    for (std::size_t j = 0; j < p.owned; j++) neighbours += length(p.position[j] - p.position[i]) < near;
    EXPECT_GT(neighbours, 4) << i;
  }
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
