// SPDX-License-Identifier: Apache-2.0
#include "core/sheet/data/topology.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "core/geometry/basic/shape_error.hpp"
#include "core/geometry/builtin/sheet_meshes.hpp"

namespace thaw {
namespace {

/// All triangles of the rings, each starting at its smallest corner.
std::set<std::array<std::uint32_t, 3>> trianglesOf(const SheetTopology& t) {
  std::set<std::array<std::uint32_t, 3>> all;
  for (std::uint32_t v = 0; v + 1 < t.first.size(); v++)
    for (std::uint32_t k = t.first[v]; k < t.first[v + 1]; k++) {
      if (!t.ring[k].triangle) continue;
      std::array<std::uint32_t, 3> tri{v, t.ring[k].to, t.ring[t.first[v] + t.ring[k].next].to};
      std::rotate(tri.begin(), std::min_element(tri.begin(), tri.end()), tri.end());
      all.insert(tri);
    }
  return all;
}

void expectSameTriangles(const TriangleMesh& mesh) {
  std::set<std::array<std::uint32_t, 3>> expected;
  for (std::array<std::uint32_t, 3> tri : mesh.triangles) {
    std::rotate(tri.begin(), std::min_element(tri.begin(), tri.end()), tri.end());
    expected.insert(tri);
  }
  const SheetTopology t = sheetTopology(mesh);
  EXPECT_EQ(trianglesOf(t), expected);
  EXPECT_EQ(std::count_if(t.ring.begin(), t.ring.end(), [](const RingEdge& r) { return r.triangle; }),
            static_cast<std::ptrdiff_t>(3 * mesh.triangles.size()));
}

TEST(SheetTopology, RingsOfAClosedMeshAreComplete) {
  const TriangleMesh mesh = sphereSheet(1, 0.1);
  const SheetTopology t = sheetTopology(mesh);
  expectSameTriangles(mesh);
  ASSERT_EQ(t.closed.size(), 1u);
  EXPECT_TRUE(t.closed[0]);
  EXPECT_NEAR(t.volume[0], 4.18879, 0.1);
  EXPECT_EQ(t.hinges.size(), 3 * mesh.vertices.size() - 6);
  double area = 0;
  for (const double a : t.area) area += a;
  EXPECT_NEAR(area, 12.566, 0.2);
  for (std::size_t v = 0; v < mesh.vertices.size(); v++)
    for (std::uint32_t k = t.first[v]; k < t.first[v + 1]; k++)
      EXPECT_EQ(t.ring[k].next, (k - t.first[v] + 1) % (t.first[v + 1] - t.first[v]));
}

TEST(SheetTopology, FindsBordersAndComponents) {
  TriangleMesh mesh = gridSheet(1, 0.6, 0.1);
  const std::size_t n = mesh.vertices.size();
  expectSameTriangles(mesh);
  const TriangleMesh ball = sphereSheet(0.2, 0.1);
  for (const Vec3d& x : ball.vertices) mesh.vertices.push_back(x + Vec3d{0, 0, 2});
  for (auto tri : ball.triangles) {
    for (std::uint32_t& v : tri) v += static_cast<std::uint32_t>(n);
    mesh.triangles.push_back(tri);
  }
  expectSameTriangles(mesh);
  const SheetTopology t = sheetTopology(mesh);
  ASSERT_EQ(t.closed.size(), 2u);
  EXPECT_FALSE(t.closed[0]);
  EXPECT_TRUE(t.closed[1]);
  EXPECT_EQ(t.volume[0], 0);
  EXPECT_EQ(t.component[n - 1], 0u);
  EXPECT_EQ(t.component[n], 1u);
}

TEST(SheetTopology, SplitsFansThatTouchInAPoint) {
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {-1, 0, 0}, {-1, -1, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 3, 4}};
  expectSameTriangles(mesh);
  const SheetTopology t = sheetTopology(mesh);
  EXPECT_EQ(t.first[1] - t.first[0], 4u);
  EXPECT_EQ(t.closed.size(), 1u);
}

TEST(SheetTopology, RefusesInvalidMeshes) {
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}};
  mesh.triangles = {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}};
  EXPECT_THROW(sheetTopology(mesh), ShapeError);  // three triangles at an edge
  mesh.triangles = {{0, 1, 2}, {0, 1, 3}};
  EXPECT_THROW(sheetTopology(mesh), ShapeError);  // opposite orientations
  mesh.triangles = {{0, 1, 2}};
  EXPECT_THROW(sheetTopology(mesh), ShapeError);  // vertices without triangles
  mesh.vertices.resize(3);
  EXPECT_NO_THROW(sheetTopology(mesh));
  mesh.vertices[2] = {2, 0, 0};
  EXPECT_THROW(sheetTopology(mesh), ShapeError);  // no area
  mesh.triangles = {{0, 1, 7}};
  EXPECT_THROW(sheetTopology(mesh), ShapeError);
}

TEST(SheetMeshes, HaveTheirNamedShapes) {
  const TriangleMesh head = headSheet(1, 0.05), dome = domeSheet(0.5, 0.3, 0.05, 12, 0.02),
                     brow = foreheadSheet(1, 1, 0.6, 0.05, 0.02, 5);
  const SheetTopology h = sheetTopology(head), d = sheetTopology(dome), b = sheetTopology(brow);
  EXPECT_EQ(h.closed, std::vector<std::uint8_t>{1});
  EXPECT_GT(h.volume[0], 0);
  EXPECT_EQ(d.closed, std::vector<std::uint8_t>{0});
  EXPECT_EQ(b.closed, std::vector<std::uint8_t>{0});
  // even triangles: the smallest vertex area is near the mean
  for (const SheetTopology* t : {&h, &d, &b}) {
    double sum = 0, least = 1e9;
    for (const double a : t->area) sum += a, least = std::min(least, a);
    EXPECT_GT(least, 0.15 * sum / static_cast<double>(t->area.size()));
  }
}

}  // namespace
}  // namespace thaw
