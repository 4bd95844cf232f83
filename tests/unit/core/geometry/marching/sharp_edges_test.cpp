// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/marching/sharp_edges.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/geometry/marching/polygonise.hpp"
#include "tests/support/closed_mesh.hpp"
#include "tests/support/meshes.hpp"

namespace thaw {
namespace {

constexpr double outer = 0.15, inner = 0.135, half = 0.075, bottom = -0.055, spacing = 0.005;

/// A cup: a cylinder, less one that leaves its wall and bottom.
Shape cup() {
  Shape cup, hole;
  hole.kind = ShapeKind::Cylinder;
  hole.radius = inner, hole.height = 2 * half;
  Shape whole = hole;
  whole.radius = outer;
  hole.move = {0, 0, 0.02};
  cup.kind = ShapeKind::Difference;
  cup.parts = {whole, hole};
  return cup;
}

TriangleMesh marched(const SignedDistance& shape) {
  return polygonise([&](const Vec3d& x) { return shape.distanceWithin(x, 2 * spacing); },
                    {{-0.17, -0.17, -0.1}, {0.17, 0.17, 0.1}}, spacing);
}

/// Distance (m) of a point from the nearest circle of the cup's edges.
double toEdges(const Vec3d& x) {
  const double r = std::hypot(x.x, x.y);
  double least = never;
  for (const auto& [radius, z] : {std::pair{outer, half}, {outer, -half}, {inner, half}, {inner, bottom}})
    least = std::min(least, std::hypot(r - radius, x.z - z));
  return least;
}

/// Number of vertices on the edges, and the largest distance (m) between the sharp sides of the mesh and
/// them.
struct Edges {
  int vertices = 0;
  double off = 0;
};

Edges edgesOf(const TriangleMesh& mesh) {
  Edges e;
  for (const Vec3d& x : mesh.vertices) e.vertices += toEdges(x) < 1e-4;
  // A triangle with corners on several faces would cut an edge off.
  for (const auto& t : mesh.triangles) {
    const Vec3d &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
    const Vec3d middle = (a + b + c) * (1.0 / 3);
    if (toEdges(middle) > spacing) continue;
    const double r = std::hypot(middle.x, middle.y);
    e.off = std::max(e.off, std::min({std::abs(r - outer), std::abs(r - inner), std::abs(middle.z - half),
                                      std::abs(middle.z + half), std::abs(middle.z - bottom)}));
  }
  return e;
}

TEST(SharpEdges, RimsOfACupAreCircles) {
  const auto shape = makeSignedDistance(cup());
  const TriangleMesh before = marched(*shape), after = withSharpEdges(before, *shape, spacing);
  expectClosed(after);
  EXPECT_GT(edgesOf(before).off, 0.2 * spacing);
  EXPECT_LT(edgesOf(after).off, 0.02 * spacing);  // chords of circles: 2e-5 m
  EXPECT_GT(edgesOf(after).vertices, 500);        // 3.6 m of edges
  const double volume = std::numbers::pi * (outer * outer * 2 * half - inner * inner * (half - bottom));
  EXPECT_NEAR(volumeOf(after), volume, 1e-3 * volume);
}

TEST(SharpEdges, CornersOfABoxAreInPlace) {
  Shape box;
  box.kind = ShapeKind::Box;
  box.size = {0.2, 0.1, 0.14};
  const auto shape = makeSignedDistance(box);
  const TriangleMesh mesh = withSharpEdges(marched(*shape), *shape, spacing);
  expectClosed(mesh);
  for (int k = 0; k < 8; k++) {
    const Vec3d corner{k & 1 ? 0.1 : -0.1, k & 2 ? 0.05 : -0.05, k & 4 ? 0.07 : -0.07};
    double nearest = never;
    for (const Vec3d& x : mesh.vertices) nearest = std::min(nearest, length(x - corner));
    EXPECT_LT(nearest, 0.02 * spacing) << k;
  }
  EXPECT_NEAR(volumeOf(mesh), 0.2 * 0.1 * 0.14, 1e-4 * 0.2 * 0.1 * 0.14);
}

TEST(SharpEdges, SmoothSurfacesKeepTheirTriangles) {
  Shape ball;
  ball.kind = ShapeKind::Sphere;
  ball.radius = 0.1;
  const auto shape = makeSignedDistance(ball);
  const TriangleMesh before = marched(*shape), after = withSharpEdges(before, *shape, spacing);
  EXPECT_EQ(after.triangles, before.triangles);
  for (const Vec3d& x : after.vertices) EXPECT_NEAR(length(x), 0.1, 1e-12);
}

}  // namespace
}  // namespace thaw
