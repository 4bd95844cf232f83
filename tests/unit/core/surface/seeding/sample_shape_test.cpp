// SPDX-License-Identifier: Apache-2.0
// Surfaces of solids with shapes instead of meshes are sampled from their shapes.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/math/hash_random.hpp"
#include "core/surface/seeding/sample_mesh.hpp"
#include "tests/support/surface/surface_world.hpp"

namespace thaw {
namespace {

using namespace test;

using std::numbers::pi;

/// A scene with a spacing of 1 m and surfels half of that apart.
Scene solidScene() {
  Scene s = emptyScene(1, {-20, -20, -20}, {20, 20, 20});
  s.domain.gravity = {};
  s.materials.emplace_back();
  s.materials[0].name = "rubber";
  s.materials[0].young = {1e6, 0};
  s.surface.on = true;
  return s;
}

void addBody(Scene& s, const Shape& shape) {
  s.bodies.emplace_back();
  s.bodies.back().name = "body" + std::to_string(s.bodies.size());
  s.bodies.back().shape = shape;
}

Shape cylinderOf(double radius, double height) {
  Shape s;
  s.kind = ShapeKind::Cylinder;
  s.radius = radius;
  s.height = height;
  return s;
}

Shape combined(ShapeKind kind, const Shape& a, const Shape& b) {
  Shape s;
  s.kind = kind;
  s.parts = {a, b};
  return s;
}

double farthestOff(const World& w) {
  double off = 0;
  std::vector<std::shared_ptr<const SignedDistance>> shapes;
  for (const Body& b : w.scene.bodies) shapes.push_back(makeSignedDistance(b.shape));
  for (std::size_t i = 0; i < w.surface.surfels.owned; i++) {
    double least = 1e9;
    for (const auto& shape : shapes)
      least = std::min(least, std::abs(shape->distance(w.surface.surfels.position[i])));
    off = std::max(off, least);
  }
  return off;
}

/// Largest distance in surfel spacings between a point of the shape, found by its distance function, and the
/// nearest surfel.
double largestHole(const World& w, const SignedDistance& shape) {
  const Surfels& f = w.surface.surfels;
  const Bounds b = shape.bounds();
  double hole = 0;
  for (std::uint64_t k = 0; k < 4000; k++) {
    Vec3d x, n;
    for (int a = 0; a < 3; a++)
      x[a] = b.min[a] +
             (b.max[a] - b.min[a]) * randomUniform(7, Purpose::Test, k, static_cast<std::uint64_t>(a));
    for (int pass = 0; pass < 6; pass++) {
      const double d = shape.distance(x, &n);
      x -= d * n;
    }
    if (std::abs(shape.distance(x)) > 1e-6) continue;
    double least = 1e9;
    for (std::size_t i = 0; i < f.owned; i++) least = std::min(least, length(f.position[i] - x));
    hole = std::max(hole, least);
  }
  return hole / w.surface.spacing;
}

TEST(SampleShape, SolidsMatchAreaVolumeAndPositionOfTheirShapes) {
  struct Exact {
    const char* name;
    Shape shape;
    double area, volume;
  };
  Shape ball, torus, aslant = boxOf({-6, -5, -3}, {6, 5, 3});
  ball.kind = ShapeKind::Sphere;
  ball.radius = 6;
  torus.kind = ShapeKind::Torus;
  torus.radius = 8;
  torus.radius2 = 3;
  aslant.rotate = {0.3, 0.5, 0.7};
  const Shape box = boxOf({-6, -5, -3}, {6, 5, 3}), rod = cylinderOf(3, 14);
  // a grown surface would be -29 % off
  for (const Exact& e :
       {Exact{"plate of one layer", boxOf({-8, -8, -0.5}, {8, 8, 0.5}), 576, 256},
        {"box", box, 504, 720},  // -14 %
        {"box aslant", aslant, 504, 720},
        {"cylinder", cylinderOf(5, 12), 170 * pi, 300 * pi},  // -7 %
        {"ball", ball, 144 * pi, 288 * pi},
        {"torus", torus, 96 * pi * pi, 144 * pi * pi},
        {"union", combined(ShapeKind::Union, box, rod), 504 + 48 * pi, 720 + 72 * pi},
        {"difference", combined(ShapeKind::Difference, box, rod), 504 + 18 * pi, 720 - 54 * pi}}) {
    Scene s = solidScene();
    addBody(s, e.shape);
    SurfaceWorld world(s);
    ASSERT_EQ(world.components().size(), 1u) << e.name;
    const SurfaceComponent& c = world.components()[0];
    const double off = farthestOff(world.w), hole = largestHole(world.w, *makeSignedDistance(e.shape));
    std::printf("%s: %zu surfels, area %+.2f %%, volume %+.2f %%, %.2g spacings off it, hole %.2f\n", e.name,
                world.w.surface.surfels.owned, 100 * (c.area / e.area - 1), 100 * (c.volume / e.volume - 1),
                off, hole);
    EXPECT_NEAR(c.area / e.area, 1, 0.01) << e.name;
    EXPECT_NEAR(c.volume / e.volume, 1, 0.01) << e.name;
    EXPECT_LT(off, 1e-6) << e.name;
    EXPECT_LT(hole, 1.1) << e.name;
    const std::size_t surfels = world.w.surface.surfels.owned;
    for (int k = 0; k < 2; k++) world.update();  // and stays so at rest
    EXPECT_EQ(world.w.surface.surfels.owned, surfels) << e.name;
    EXPECT_LT(farthestOff(world.w), 1e-6) << e.name;
  }
}

TEST(SampleShape, NormalsAreThoseOfTheFaces) {
  Shape ball;
  ball.kind = ShapeKind::Sphere;
  ball.radius = 3;
  for (const Shape& shape : {boxOf({-6, -5, -3}, {6, 5, 3}), cylinderOf(5, 12), ball}) {
    const auto solid = makeSignedDistance(shape);
    for (const SurfaceSample& s : sampleShape(shape, {}, 0.5, 1)) {
      Vec3d n;
      solid->distance(s.position + 0.1 * s.normal, &n);
      ASSERT_GT(dot(n, s.normal), 0.999994);  // 0.2 degrees
    }
  }
}

TEST(SampleShape, SamplesDoNotDependOnThePosition) {
  const Shape here = cylinderOf(3, 4);
  Shape there = here;
  there.move = {0.1, 0.7, 12.3};
  const auto a = sampleShape(here, {}, 0.5, 1), b = sampleShape(there, {}, 0.5, 1);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t k = 0; k < a.size(); k++)
    ASSERT_LT(length(a[k].position + there.move - b[k].position), 1e-12);
}

TEST(SampleShape, FacingPlatesKeepTheirPositions) {  // a surface grown from particles would be 0.25
                                                     // spacings off, since each plate is alone
  for (const double gap : {1.2, 0.0}) {
    Scene s = solidScene();
    for (const double side : {-1.0, 1.0})
      addBody(s, boxOf({-8, -8, side * (1 + 0.5 * gap) - 1}, {8, 8, side * (1 + 0.5 * gap) + 1}));
    SurfaceWorld world(s);
    ASSERT_EQ(world.components().size(), 2u);
    EXPECT_LT(farthestOff(world.w), gap > 0 ? 1e-6 : 0.1) << gap;  // where the plates touch, surfels near the
                                                                   // rim count as pressed into each other
    for (const SurfaceComponent& c : world.components()) EXPECT_NEAR(c.area / 640, 1, 0.01);
  }
}

TEST(SampleShape, ThinTiltedRodIsOneComponentAndItsPiecesAreReported) {
  Scene s = solidScene();
  Shape rod = cylinderOf(0.6, 20);
  rod.rotate = {20 * pi / 180, 30 * pi / 180, 0};
  addBody(s, rod);
  SurfaceWorld world(s);
  EXPECT_EQ(world.components().size(), 1u);
  ASSERT_EQ(world.tools.pieces.size(), 1u);
  EXPECT_EQ(world.tools.pieces[0].body, 0u);
  EXPECT_EQ(world.tools.pieces[0].pieces, 3);
  s.surface.source = SurfelSource::Particles;
  SurfaceWorld grown(s);
  EXPECT_EQ(grown.components().size(), 3u);
  EXPECT_EQ(grown.tools.pieces.size(), 1u);
  Scene two = solidScene();  // bodies whose shapes are separate give no warning
  addBody(two, combined(ShapeKind::Union, boxOf({-6, -2, -2}, {-1, 2, 2}), boxOf({1, -2, -2}, {6, 2, 2})));
  EXPECT_TRUE(SurfaceWorld(two).tools.pieces.empty());
}

TEST(SampleShape, BodiesJoinedAcrossAPeriodicSideHaveNoFaceThere) {
  Scene s = solidScene();
  s.domain.min = {-9, -20, -20};
  s.domain.max = {9, 20, 20};
  s.domain.side[0] = {Side::Periodic, Side::Periodic};
  addBody(s, boxOf({-9, -3, -3}, {9, 3, 3}));
  SurfaceWorld world(s);
  const Surfels& f = world.w.surface.surfels;
  EXPECT_GT(f.owned, 1000u);
  for (std::size_t i = 0; i < f.owned; i++) ASSERT_LT(std::abs(f.normal[i].x), 0.5);
}

TEST(SampleShape, LiquidSurfacesAreGrown) {
  Scene s = solidScene();
  addBody(s, boxOf({-6, -5, -3}, {6, 5, 3}));
  EXPECT_TRUE(isSampled(s, 0));
  EXPECT_FALSE(hasMesh(s, 0));
  Scene cut = s, liquid = s, asked = s, molten = s;
  cut.numerics.overlap = OverlapRule::RemoveLater;
  liquid.materials[0].young = {0, 0};
  asked.surface.source = SurfelSource::Particles;
  molten.materials[0].solidus = 300;
  molten.materials[0].liquidus = 310;
  molten.bodies[0].temperature = 305;
  for (const Scene& grown : {cut, liquid, asked, molten}) EXPECT_FALSE(isSampled(grown, 0));
  molten.bodies[0].temperature = 299;
  EXPECT_TRUE(isSampled(molten, 0));
}

TEST(SampleShape, MoltenBodiesHoldTheirOwnVolume) {  // a ball of R/dx = 5 has 552 particles, 5 % more than
                                                     // the volume of its shape
  Scene s = solidScene();
  Material& m = s.materials[0];
  m.viscosity = {1, 1};
  m.heatSource = 1e-9;  // switches heat on
  m.solidus = 300;
  m.liquidus = 310;
  Shape ball;
  ball.kind = ShapeKind::Sphere;
  ball.radius = 5;
  addBody(s, ball);
  s.bodies[0].temperature = 290;
  SurfaceWorld world(s);
  ASSERT_TRUE(world.w.particles.liquid.active);
  const double exact = 500 * pi / 3;
  EXPECT_NEAR(world.components()[0].volume / exact, 1, 0.01);
  EXPECT_NEAR(world.components()[0].targetVolume / exact, 1, 0.01);
  for (std::size_t i = 0; i < world.w.solids.owned; i++)
    world.w.solids.deformation[i] = 0.99 * identity3<double>();
  for (int k = 0; k < 3; k++) {  // the target falls once under compression, not with each update
    world.update();
    EXPECT_NEAR(world.components()[0].targetVolume / exact, 0.99 * 0.99 * 0.99, 0.01) << k;
  }
  for (std::size_t i = 0; i < world.w.particles.owned; i++)
    world.w.particles.liquid[i] = 1, world.w.particles.phase[i] = Liquid;
  for (int k = 0; k < 3; k++) world.update();
  EXPECT_GT(world.components()[0].particleVolume, 1.04 * exact);
  EXPECT_NEAR(world.components()[0].targetVolume / world.components()[0].particleVolume, 1, 1e-12);
  EXPECT_NEAR(world.components()[0].volume / world.components()[0].particleVolume, 1, 0.01);
}

}  // namespace
}  // namespace thaw
