// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/shapes/shape_mesh.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/geometry/basic/shape_error.hpp"

namespace thaw {
namespace {

using std::numbers::pi;

/// Enclosed volume; negative if the mesh faces inward.
double meshVolume(const TriangleMesh& m) {
  double v = 0;
  for (const auto& t : m.triangles) v += dot(m.vertices[t[0]], cross(m.vertices[t[1]], m.vertices[t[2]])) / 6;
  return v;
}

Shape shapeOf(ShapeKind kind) {
  Shape s;
  s.kind = kind;
  s.size = {3, 2, 1};
  s.radius = 2;
  s.radius2 = 0.5;
  s.height = 3;
  s.thickness = 0.2;
  return s;
}

TEST(ShapeMesh, HasTheAreaAndVolumeOfSimpleShapes) {
  struct Exact {
    ShapeKind kind;
    double area, volume;
  };
  const double R = 2, h = 3, t = 0.2, in = R - t;
  for (const Exact& e : {Exact{ShapeKind::Box, 22, 6},
                         {ShapeKind::Sphere, 4 * pi * R * R, 4 * pi / 3 * R * R * R},
                         {ShapeKind::Cylinder, 2 * pi * R * (R + h), pi * R * R * h},
                         {ShapeKind::Torus, 4 * pi * pi * R * 0.5, 2 * pi * pi * R * 0.25},
                         {ShapeKind::Glass, 2 * pi * R * h + 2 * pi * R * R + 2 * pi * in * (h - t),
                          pi * R * R * h - pi * in * in * (h - t)}}) {
    Shape s = shapeOf(e.kind);
    s.scale = 1.5;
    s.rotate = {0.3, -0.4, 1.2};
    s.move = {5, 6, 7};
    const TriangleMesh m = shapeMesh(s, 1e-4, {});
    const auto kind = static_cast<int>(e.kind);
    EXPECT_NEAR(areaOf(m) / (1.5 * 1.5 * e.area), 1, 1e-3) << kind;
    EXPECT_NEAR(meshVolume(m) / (1.5 * 1.5 * 1.5 * e.volume), 1, 1e-3) << kind;
    const auto solid = makeSignedDistance(s);
    for (const Vec3d& v : m.vertices) ASSERT_NEAR(solid->distance(v), 0, 1e-9) << kind;
    for (const auto& c : m.triangles) {
      const Vec3d middle = (m.vertices[c[0]] + m.vertices[c[1]] + m.vertices[c[2]]) / 3.0;
      ASSERT_LT(std::abs(solid->distance(middle)), 2e-4) << kind;
    }
  }
}

TEST(ShapeMesh, ReversesSubtractedShapesAndKeepsNestedPlaces) {
  Shape cut = shapeOf(ShapeKind::Difference), hole = shapeOf(ShapeKind::Sphere),
        plane = shapeOf(ShapeKind::HalfSpace);
  hole.radius = 0.4;
  hole.move = {0.2, 0.1, 0};
  cut.parts = {shapeOf(ShapeKind::Box), hole};
  cut.scale = 2;
  cut.move = {1, 1, 1};
  EXPECT_NEAR(meshVolume(shapeMesh(cut, 1e-4, {})), 8 * (6 - 4 * pi / 3 * 0.064), 1e-2);
  plane.normal = {0, 0, 1};
  Shape half = shapeOf(ShapeKind::Intersection);
  half.parts = {shapeOf(ShapeKind::Sphere), plane};
  half.move = {10, 0, 0};
  const TriangleMesh m = shapeMesh(half, 1e-3, {});
  Bounds seen{{1e9, 1e9, 1e9}, {-1e9, -1e9, -1e9}};
  // the plane, across the whole ball
  for (std::size_t k = m.triangles.size() - 2; k < m.triangles.size(); k++)
    for (const std::uint32_t v : m.triangles[k])
      for (int a = 0; a < 3; a++)
        seen.min[a] = std::min(seen.min[a], m.vertices[v][a]),
        seen.max[a] = std::max(seen.max[a], m.vertices[v][a]);
  EXPECT_LT(seen.min.x, 8);
  EXPECT_GT(seen.max.x, 12);
  EXPECT_NEAR(seen.max.z, 0, 1e-12);
  EXPECT_THROW(shapeMesh(plane, 1e-3, {}), ShapeError);
}

}  // namespace
}  // namespace thaw
