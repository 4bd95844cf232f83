// SPDX-License-Identifier: Apache-2.0
// Exported meshes of obstacles are closed, outward and without slivers.
#include "io/surface_mesh/even_triangles.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/geometry/basic/signed_distance.hpp"
#include "io/surface_mesh/obstacle_mesh.hpp"
#include "io/surface_mesh/triangle_angles.hpp"
#include "tests/support/closed_mesh.hpp"
#include "tests/support/meshes.hpp"

namespace thaw {
namespace {

using std::numbers::pi;

struct Angles {
  double least = 180, share = 0;  // degrees; fraction below 15 degrees
};

Angles anglesOf(const TriangleMesh& mesh) {
  Angles a;
  for (const auto& t : mesh.triangles) {
    const double angle = 180 / pi *
                         smallestAngle(mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]);
    a.least = std::min(a.least, angle);
    if (angle < 15) a.share += 1.0 / static_cast<double>(mesh.triangles.size());
  }
  return a;
}

Shape shapeOf(ShapeKind kind) {
  Shape s;
  s.kind = kind;
  return s;
}

Shape boxOf(const Vec3d& size) {
  Shape s = shapeOf(ShapeKind::Box);
  s.size = size;
  return s;
}

/// off: m, largest distance of a vertex from the shape.
void expectEven(const Shape& shape, double volume, double off = 1e-9) {
  const TriangleMesh mesh = evenShapeMesh(shape, 2e-3, {});
  expectClosed(mesh);
  EXPECT_NEAR(volumeOf(mesh), volume, 0.06 * volume);  // chords of thin tubes
  EXPECT_GE(anglesOf(mesh).least, 15);
  EXPECT_LT(mesh.triangles.size(), 100000u);
  const auto distance = makeSignedDistance(shape);
  for (const Vec3d& x : mesh.vertices) EXPECT_NEAR(distance->distance(x), 0, off);
}

}  // namespace

TEST(EvenTriangles, CoverBoxesOfAnyThickness) {
  for (const double thickness : {1.0, 0.3, 0.05, 0.01, 0.003}) {
    expectEven(boxOf({1, 0.7, thickness}), 0.7 * thickness);
    expectEven(boxOf({thickness, 1, thickness}), thickness * thickness);
  }
  Shape placed = boxOf({1, 0.02, 1});
  placed.move = {3, 2, 1}, placed.rotate = {0.3, 0.2, 0.1}, placed.scale = 0.5;
  expectEven(placed, 0.02 * 0.125);
}

TEST(EvenTriangles, CoverRoundShapes) {
  Shape s = shapeOf(ShapeKind::Sphere);
  s.radius = 0.5;
  expectEven(s, 4 * pi / 3 * 0.125);
  for (const double height : {0.01, 0.1, 1.0}) {
    s = shapeOf(ShapeKind::Cylinder);
    s.radius = 0.5, s.height = height;
    expectEven(s, pi * 0.25 * height);
  }
  s.radius = 0.01, s.height = 1;
  expectEven(s, pi * 1e-4);
  for (const double thickness : {0.1, 0.01}) {
    s = shapeOf(ShapeKind::Glass);
    s.radius = 0.3, s.height = 1, s.thickness = thickness;
    const double inner = s.radius - thickness;
    expectEven(s, pi * (0.09 - inner * inner * (1 - thickness)));
  }
  for (const double tube : {0.03, 0.15, 0.25}) {
    s = shapeOf(ShapeKind::Torus);
    s.radius = 0.3, s.radius2 = tube;
    expectEven(s, 2 * pi * pi * 0.3 * tube * tube, 2e-3);  // rows between corners
  }
}

TEST(EvenTriangles, CoverRectangles) {
  const TriangleMesh mesh = evenPolygon({{0, 0, 0}, {2, 0, 0}, {2, 0.05, 0}, {0, 0.05, 0}});
  EXPECT_GE(anglesOf(mesh).least, 15);
  EXPECT_NEAR(areaOf(mesh), 0.1, 1e-12);
  for (const auto& t : mesh.triangles)
    EXPECT_GT(cross(mesh.vertices[t[1]] - mesh.vertices[t[0]], mesh.vertices[t[2]] - mesh.vertices[t[0]]).z,
              0);
  EXPECT_EQ(evenPolygon({{0, 0, 0}, {1, 0, 0}, {0.5, 1, 0}}).triangles.size(), 1u);
}

TEST(EvenTriangles, CoverDifferencesOfObstacles) {
  Obstacle bowl;
  bowl.shape = shapeOf(ShapeKind::Difference);
  Shape ball = shapeOf(ShapeKind::Sphere), hole = boxOf({2, 2, 1});
  ball.radius = 0.5, hole.move = {0, 0, 0.6};
  bowl.shape.parts = {ball, hole};
  const TriangleMesh few = obstacleMesh(bowl, {}).mesh,
                     even = obstacleMesh(bowl, {}, ObstacleTriangles::Even).mesh;
  EXPECT_LT(anglesOf(few).least, 5) << "else this test shows nothing";
  EXPECT_GE(anglesOf(even).least, 5);
  EXPECT_LE(anglesOf(even).share, 0.001);
  EXPECT_NEAR(volumeOf(even), volumeOf(few), 0.01 * volumeOf(few));
  // Vertices are on the shape, and some hundred of them on its rim. Tangent planes of the ball leave it by up
  // to the square of a cube's edge over its diameter.
  const double off = 1.0 / (80 * 80);
  const auto shape = makeSignedDistance(bowl.shape);
  int onRim = 0;
  for (const Vec3d& x : even.vertices) {
    EXPECT_NEAR(shape->distance(x), 0, off);
    onRim += std::hypot(std::hypot(x.x, x.y) - std::sqrt(0.24), x.z - 0.1) < 2 * off;
  }
  EXPECT_GT(onRim, 200);
}

}  // namespace thaw
