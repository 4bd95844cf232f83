// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/shapes/primitives.hpp"

#include <gtest/gtest.h>

#include <functional>

#include "core/geometry/basic/shape_error.hpp"
#include "tests/support/meshes.hpp"

namespace thaw {
namespace {

std::shared_ptr<const SignedDistance> make(ShapeKind kind, const std::function<void(Shape&)>& change = {}) {
  Shape s;
  s.kind = kind;
  if (change) change(s);
  return makeSignedDistance(s);
}

const ShapeKind primitives[] = {ShapeKind::Box,   ShapeKind::Sphere,    ShapeKind::Cylinder,
                                ShapeKind::Torus, ShapeKind::HalfSpace, ShapeKind::Glass};

TEST(Primitives, DistancesMatchHandComputedValues) {
  EXPECT_DOUBLE_EQ(make(ShapeKind::Box)->distance({1.5, 0, 0}), 1);
  EXPECT_DOUBLE_EQ(make(ShapeKind::Box)->distance({0.5 + 3, 0.5 + 4, 0}), 5);
  EXPECT_DOUBLE_EQ(make(ShapeKind::Box)->distance({0.1, 0.2, -0.3}), -0.2);
  EXPECT_DOUBLE_EQ(make(ShapeKind::Sphere)->distance({0, 0, 0}), -0.5);
  EXPECT_DOUBLE_EQ(make(ShapeKind::Cylinder)->distance({0.3, 0.4, 0.5}), 0);
  EXPECT_DOUBLE_EQ(make(ShapeKind::Cylinder)->distance({3.5, 0, 4.5}), 5);
  EXPECT_NEAR(make(ShapeKind::Cylinder)->distance({0.4, 0, 0}), -0.1, 1e-15);
  EXPECT_NEAR(make(ShapeKind::Torus)->distance({0.5, 0, 0}), -0.1, 1e-15);
  EXPECT_NEAR(make(ShapeKind::Torus)->distance({0, 0, 0}), 0.4, 1e-15);
  EXPECT_DOUBLE_EQ(make(ShapeKind::HalfSpace,
                        [](Shape& s) {
                          s.normal = {0, 0, 2}, s.point = {5, 6, 1};
                        })
                       ->distance({0, 0, 3}),
                   2);
  const auto glass = make(ShapeKind::Glass, [](Shape& s) { s.radius = 1, s.height = 2, s.thickness = 0.1; });
  EXPECT_NEAR(glass->distance({0, 0, 0.05}), -0.05, 1e-15);   // in the floor
  EXPECT_NEAR(glass->distance({0, 0.95, 1}), -0.05, 1e-15);   // in the wall
  EXPECT_NEAR(glass->distance({0, 0, 1}), 0.9, 1e-15);        // in the room
  EXPECT_NEAR(glass->distance({0.5, 0, 0.3}), 0.2, 1e-15);    // over the floor
  EXPECT_NEAR(glass->distance({-0.95, 0, 2.2}), 0.2, 1e-15);  // over the rim
  EXPECT_NEAR(glass->distance({0, 0, -1}), 1, 1e-15);
  EXPECT_NEAR(glass->distance({0.6, 0, 2.4}), 0.5, 1e-15);  // from above the cavity to the inner rim
}

TEST(Primitives, GradientsAreUnitDerivatives) {
  for (const ShapeKind kind : primitives) {
    const auto d = make(kind);
    int checked = 0;
    for (std::uint64_t k = 0; k < 2000; k++) {
      const Vec3d x = randomPoint({{-1, -1, -1.2}, {1, 1, 1.2}}, k);
      Vec3d g;
      const double v = d->distance(x, &g);
      ASSERT_NEAR(length(g), 1, 1e-12);
      ASSERT_EQ(d->inside(x), v < 0);
      // a step along the gradient ends on the surface, except at edges of the medial axis
      if (v > 0) { ASSERT_NEAR(d->distance(x - g * v), 0, 1e-12); }
      for (int a = 0; a < 3; a++) {
        Vec3d h;
        h[a] = 1e-6;
        const double up = d->distance(x + h), down = d->distance(x - h);
        ASSERT_LE(std::abs(up - v), 1e-6 * (1 + 1e-9));
        if (std::abs(up + down - 2 * v) > 1e-10) continue;
        ASSERT_NEAR((up - down) / 2e-6, g[a], 2e-4) << static_cast<int>(kind);
        checked++;
      }
    }
    EXPECT_GT(checked, 5000) << static_cast<int>(kind);
  }
}

TEST(Primitives, GradientsAreDefinedEverywhere) {
  for (const ShapeKind kind : primitives) {
    const auto d = make(kind);
    for (const Vec3d& x :
         {Vec3d{0, 0, 0}, Vec3d{0.5, 0, 0}, Vec3d{0.5, 0.5, 0.5}, Vec3d{0, 0, 0.5}, Vec3d{0, 0, -0.5},
          Vec3d{0, 0, 0.01}, Vec3d{-0.5, 0, -0.5}, Vec3d{0.49, 0, 1}, Vec3d{0, 0, 7}}) {
      Vec3d g;
      const double v = d->distance(x, &g);
      EXPECT_TRUE(std::isfinite(v));
      EXPECT_NEAR(length(g), 1, 1e-12) << static_cast<int>(kind);
    }
  }
}

TEST(Primitives, BoundsAreTight) {
  for (const ShapeKind kind : primitives) {
    if (kind == ShapeKind::HalfSpace) continue;
    const auto d = make(kind, [](Shape& s) {
      s.size = {0.7, 0.5, 0.9}, s.rotate = {0.3, -0.7, 1.1}, s.move = {3, 4, 5}, s.scale = 1.5;
    });
    const Bounds b = d->bounds();
    for (int a = 0; a < 3; a++)
      for (const bool high : {false, true}) {
        // the plane of each face touches the shape: the smallest distance on it is 0
        double least = never;
        for (std::uint64_t k = 0; k < 20000; k++) {
          Vec3d x = randomPoint(b, k);
          x[a] = high ? b.max[a] : b.min[a];
          least = std::min(least, d->distance(x));
        }
        EXPECT_GT(least, -1e-12) << static_cast<int>(kind);
        EXPECT_LT(least, 0.03) << static_cast<int>(kind);
      }
  }
}

TEST(Primitives, RefuseShapesWithoutVolume) {
  const auto fails = [](ShapeKind kind, const std::function<void(Shape&)>& change) {
    Shape s;
    s.kind = kind;
    s.where = {"a.toml", 3, 4};
    change(s);
    try {
      makeSignedDistance(s);
    } catch (const ShapeError& e) {
      EXPECT_EQ(e.where.line, 3);
      return std::string(e.what());
    }
    return std::string("none");
  };
  EXPECT_NE(fails(ShapeKind::Box, [](Shape& s) { s.size.y = 0; }).find("box"), std::string::npos);
  EXPECT_NE(fails(ShapeKind::Sphere, [](Shape& s) { s.radius = -1; }).find("sphere"), std::string::npos);
  EXPECT_NE(fails(ShapeKind::Cylinder, [](Shape& s) { s.height = NAN; }).find("cylinder"), std::string::npos);
  EXPECT_NE(fails(ShapeKind::Glass, [](Shape& s) { s.thickness = 0.5; }).find("thickness"),
            std::string::npos);
  EXPECT_NE(fails(ShapeKind::HalfSpace, [](Shape& s) { s.normal = {}; }).find("normal"), std::string::npos);
  EXPECT_NE(fails(ShapeKind::HalfSpace, [](Shape& s) { s.fitHeight = 1; }).find("height"), std::string::npos);
  EXPECT_NE(fails(ShapeKind::HalfSpace, [](Shape& s) { s.bottom = Vec3d{}; }).find("infinite"),
            std::string::npos);
  EXPECT_NE(fails(ShapeKind::Union, [](Shape&) {}).find("parts"), std::string::npos);
  EXPECT_NE(fails(ShapeKind::Mesh, [](Shape& s) { s.mesh = "x.obj"; }).find("x.obj"), std::string::npos);
  EXPECT_NE(fails(ShapeKind::Mesh, [](Shape& s) { s.mesh = "builtin:bunny"; }).find("builtin:bust"),
            std::string::npos);
  EXPECT_NE(fails(ShapeKind::Sphere, [](Shape& s) { s.scale = 0; }).find("scale"), std::string::npos);
}

}  // namespace
}  // namespace thaw
