// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/shapes/combined.hpp"

#include <gtest/gtest.h>

#include "core/geometry/basic/shape_error.hpp"
#include "tests/support/meshes.hpp"

namespace thaw {
namespace {

Shape sphere(const Vec3d& at, double radius) {
  Shape s;
  s.kind = ShapeKind::Sphere;
  s.radius = radius;
  s.move = at;
  return s;
}

Shape of(ShapeKind kind, std::vector<Shape> parts) {
  Shape s;
  s.kind = kind;
  s.parts = std::move(parts);
  return s;
}

TEST(Combined, SetOperationsAndBoundsAreExact) {
  const Shape a = sphere({-0.3, 0, 0}, 0.5), b = sphere({0.3, 0, 0}, 0.5);
  const auto both = makeSignedDistance(of(ShapeKind::Union, {a, b})),
             less = makeSignedDistance(of(ShapeKind::Difference, {a, b})),
             common = makeSignedDistance(of(ShapeKind::Intersection, {a, b}));
  for (std::uint64_t k = 0; k < 2000; k++) {
    const Vec3d x = randomPoint({{-1, -1, -1}, {1, 1, 1}}, k);
    const bool inA = length(x - a.move) < 0.5, inB = length(x - b.move) < 0.5;
    ASSERT_EQ(both->inside(x), inA || inB);
    ASSERT_EQ(less->inside(x), inA && !inB);
    ASSERT_EQ(common->inside(x), inA && inB);
    for (const auto& d : {both, less, common}) {
      Vec3d g;
      ASSERT_EQ(d->distance(x, &g) < 0, d->inside(x));
      ASSERT_NEAR(length(g), 1, 1e-12);
      const double near = d->distanceWithin(x, 0.05);
      ASSERT_EQ(near < 0, d->inside(x));
    }
  }
  EXPECT_DOUBLE_EQ(both->bounds().max.x, 0.8);
  EXPECT_DOUBLE_EQ(common->bounds().max.x, 0.2);
  Vec3d g;
  less->distance({-0.25, 0, 0}, &g);  // towards the bite
  EXPECT_DOUBLE_EQ(g.x, 1);
}

TEST(Combined, HalfSpacesCutBounds) {
  Shape low;
  low.kind = ShapeKind::HalfSpace;
  low.point = {0, 0, 0.1};
  const auto cut = makeSignedDistance(of(ShapeKind::Difference, {sphere({}, 0.5), low})),
             kept = makeSignedDistance(of(ShapeKind::Intersection, {sphere({}, 0.5), low}));
  EXPECT_DOUBLE_EQ(cut->bounds().min.z, 0.1);
  EXPECT_DOUBLE_EQ(cut->bounds().max.z, 0.5);
  EXPECT_DOUBLE_EQ(kept->bounds().max.z, 0.1);
  EXPECT_TRUE(cut->inside({0, 0, 0.2}));
  EXPECT_FALSE(cut->inside({0, 0, 0}));
}

TEST(Placed, ScaleThenRotateThenMove) {
  Shape s;
  s.size = {2, 4, 6};
  s.scale = 0.5;
  s.rotate = {0, 0, 1.5707963267948966};
  s.move = {10, 20, 30};
  const auto d = makeSignedDistance(s);
  const Bounds b = d->bounds();
  EXPECT_NEAR(b.min.x, 9, 1e-12);
  EXPECT_NEAR(b.max.x, 11, 1e-12);
  EXPECT_NEAR(b.max.y, 20.5, 1e-12);
  EXPECT_NEAR(b.max.z, 31.5, 1e-12);
  Vec3d g;
  EXPECT_NEAR(d->distance({13, 20, 30}, &g), 2, 1e-12);
  EXPECT_LT(length(g - Vec3d{1, 0, 0}), 1e-12);
  EXPECT_NEAR(d->distance({10.9, 20, 30}), -0.1, 1e-12);
}

TEST(Placed, RotationsAreAboutXThenYThenZ) {
  const Mat3d r = rotationXyz({0.3, 0.5, 0.7});
  const Mat3d expected = rotationXyz({0, 0, 0.7}) * (rotationXyz({0, 0.5, 0}) * rotationXyz({0.3, 0, 0}));
  for (int i = 0; i < 3; i++) EXPECT_LT(length(r.row[i] - expected.row[i]), 1e-15);
  const Vec3d y = rotationXyz({1.5707963267948966, 0, 0}) * Vec3d{0, 1, 0};
  EXPECT_NEAR(y.z, 1, 1e-15);  // right-handed
}

TEST(Placed, FittedHeightAndBottom) {
  Shape s;
  s.kind = ShapeKind::Mesh;
  s.mesh = "builtin:bust";
  s.rotate = {0.4, 0.2, 1};
  s.fitHeight = 0.25;
  s.bottom = Vec3d{1, 2, 3};
  s.scale = 77, s.move = {5, 5, 5};  // ignored with a fitted height
  const Bounds b = makeSignedDistance(s)->bounds();
  EXPECT_NEAR(b.min.z, 3, 1e-12);
  EXPECT_NEAR(b.max.z, 3.25, 1e-12);
  EXPECT_NEAR(0.5 * (b.min.x + b.max.x), 1, 1e-12);
  EXPECT_NEAR(0.5 * (b.min.y + b.max.y), 2, 1e-12);
}

TEST(Placed, LoadersFailuresBecomeShapeErrors) {
  Shape s;
  s.kind = ShapeKind::Mesh;
  s.mesh = "m.obj";
  s.where = {"s.toml", 7, 1};
  const MeshLoader broken = [](const std::string& path) -> TriangleMesh {
    throw std::runtime_error(path + ":5: bad line");
  };
  try {
    makeSignedDistance(of(ShapeKind::Union, {s}), broken);
    FAIL();
  } catch (const ShapeError& e) {
    EXPECT_STREQ(e.what(), "m.obj:5: bad line");
    EXPECT_EQ(e.where.line, 7);
  }
  const MeshLoader empty = [](const std::string&) { return TriangleMesh{}; };
  EXPECT_THROW(makeSignedDistance(s, empty), ShapeError);
  const MeshLoader box = [](const std::string&) { return boxMesh({0, 0, 0}, {1, 1, 1}); };
  EXPECT_TRUE(makeSignedDistance(s, box)->inside({0.5, 0.5, 0.5}));
}

}  // namespace
}  // namespace thaw
