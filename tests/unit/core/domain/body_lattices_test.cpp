// SPDX-License-Identifier: Apache-2.0
#include "core/domain/body_lattices.hpp"

#include <gtest/gtest.h>

#include "core/geometry/sampling/sampling.hpp"
#include "tests/support/simulation.hpp"

namespace thaw {
namespace {

/// A ball (body 0) in a tank of water (body 1) that fits neither the spacing nor the ball.
Scene ballInWater() {
  Scene s = test::emptyScene(0.0113, {0, 0, 0}, {0.3, 0.3, 0.3});
  s.numerics.overlap = OverlapRule::RemoveLater;
  s.materials.resize(2);
  s.materials[0].young = {1e5, 0};
  test::addBox(s, {}, {});
  Shape& ball = s.bodies[0].shape;
  ball.kind = ShapeKind::Sphere;
  ball.radius = 0.05, ball.move = {0.151, 0.149, 0.103};
  test::addBox(s, {0, 0, 0}, {0.3, 0.3, 0.2}).material = 1;
  return s;
}

Shapes shapesOf(const Scene& s) {
  Shapes shapes;
  for (const Body& b : s.bodies) shapes.push_back(makeSignedDistance(b.shape));
  return shapes;
}

TEST(BodyLattices, ASolidFillsItsHoleInALiquid) {
  const Scene s = ballInWater();
  const Shapes shapes = shapesOf(s);
  const std::vector<SampleLattice> lattices = bodyLattices(s, shapes);
  const SignedDistance& ball = *shapes[0];
  std::vector<Vec3d> solid, removed;
  std::vector<Vec3d>* to[] = {&solid, &removed};
  for (std::size_t b = 0; b < 2; b++)
    for (std::int64_t k = 0; k < lattices[b].count[0] * lattices[b].rows(); k++)
      if (const Vec3d x = lattices[b].at(k); ball.inside(x)) to[b]->push_back(x);
  ASSERT_GT(solid.size(), 300u);
  EXPECT_EQ(solid, removed) << "the same bits";
}

TEST(BodyLattices, OnlyBodiesThatGiveWayShareALattice) {
  Scene s = ballInWater();
  for (const OverlapRule rule : {OverlapRule::Keep, OverlapRule::Error}) {
    s.numerics.overlap = rule;
    for (const SampleLattice& l : bodyLattices(s, shapesOf(s))) EXPECT_TRUE(l.equalCells());
  }
  s.numerics.overlap = OverlapRule::RemoveEarlier;
  for (const SampleLattice& l : bodyLattices(s, shapesOf(s))) EXPECT_FALSE(l.equalCells());
  s.bodies[0].shape.move.z = 0.26;
  for (const SampleLattice& l : bodyLattices(s, shapesOf(s))) EXPECT_TRUE(l.equalCells());
}

TEST(BodyLattices, TheMassOfATankIsExact) {
  for (const double spacing : {0.0097, 0.0113, 0.0137, 0.0171}) {
    Scene s = test::emptyScene(spacing, {0, 0, 0}, {0.3, 0.3, 0.3});
    s.materials.resize(1);
    test::addBox(s, {0, 0, 0}, {0.15, 0.3, 0.2});
    test::Simulation r(s);
    double mass = 0;
    for (std::size_t i = 0; i < r.particles().owned; i++) mass += r.particles().mass[i];
    EXPECT_NEAR(mass, s.materials[0].density * 0.15 * 0.3 * 0.2, 1e-9 * mass);
    EXPECT_TRUE(r.w.modules.uniform);
    EXPECT_NEAR(r.report.volume[0], 0.15 * 0.3 * 0.2, 1e-5 * r.report.volume[0]);
  }
}

TEST(BodyLattices, LiquidsOfUnequalCellsAreNotUniform) {
  Scene s = test::emptyScene(0.01, {0, 0, 0}, {0.3, 0.3, 0.3});
  s.materials.resize(1);
  test::addBox(s, {0, 0, 0}, {0.1, 0.1, 0.1});
  test::addBox(s, {0.2, 0, 0}, {0.3, 0.1, 0.104});
  EXPECT_FALSE(test::Simulation(s).w.modules.uniform);
  s.bodies[1].shape = test::boxOf({0.2, 0, 0}, {0.3, 0.1, 0.1});
  EXPECT_TRUE(test::Simulation(s).w.modules.uniform);
}

}  // namespace
}  // namespace thaw
