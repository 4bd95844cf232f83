// SPDX-License-Identifier: Apache-2.0
// A mesh as the source of an oriented body: an open one as it is, a closed one by its distance function.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/geometry/trees/point_tree.hpp"
#include "core/geometry/trees/triangle_bvh.hpp"
#include "core/oriented/sampling/sample_points.hpp"
#include "core/oriented/sampling/sample_surface.hpp"
#include "tests/support/meshes.hpp"

namespace thaw {
namespace {

constexpr double spacing = 0.02;

OrientedBody ofMesh(const std::string& path) {
  OrientedBody b;
  b.shape.kind = ShapeKind::Mesh;
  b.shape.mesh = path;
  return b;
}

SampledPoints pointsOf(const TriangleMesh& m, const OrientedBody& b = ofMesh("m")) {
  return samplePoints(b, spacing, 1, [&](const std::string&) { return m; });
}

/// A bowl: the lower half of a ball of 0.3 m.
TriangleMesh bowl() {
  TriangleMesh m = ballMesh({}, 0.3, 0.036);
  std::erase_if(m.triangles, [&](const auto& t) {
    return m.vertices[t[0]].z + m.vertices[t[1]].z + m.vertices[t[2]].z > 0;
  });
  return m;
}

TriangleMesh quad(double side) {
  return {{{0, 0, 0}, {side, 0, 0}, {side, side, 0}, {0, side, 0}}, {{0, 1, 2}, {0, 2, 3}}};
}

double nearestPair(const SampledPoints& m) {
  const PointTree tree(m.places);
  for (double r = 0.02; r < 1; r += 0.02)
    for (const Vec3d& x : m.places)
      if (tree.within(x, r * spacing).size() > 1) return r - 0.02;
  return 1;
}

TEST(OpenMesh, IsUsedUnchanged) {
  const TriangleMesh mesh = bowl();
  const TriangleBvh tree(mesh);
  const SampledPoints m = pointsOf(mesh);
  double low = 0, high = -1, off = 0, turned = 1;
  for (std::size_t i = 0; i < m.places.size(); i++) {
    const ClosestPoint there = tree.closest(m.places[i]);
    off = std::max(off, std::sqrt(there.distance2));
    turned = std::min(turned, dot(m.normals[i], there.normal));
    low = std::min(low, m.places[i].z), high = std::max(high, m.places[i].z);
  }
  EXPECT_LT(off, 1e-9) << "no particle closes the opening";
  EXPECT_GT(turned, 0.8) << "smooth normals on triangles of two spacings";
  EXPECT_LT(low, -0.29);
  EXPECT_GT(high, -spacing) << "up to the border";
  double area = 0;
  for (const auto& t : mesh.triangles)
    area += 0.5 * length(cross(mesh.vertices[t[1]] - mesh.vertices[t[0]],
                               mesh.vertices[t[2]] - mesh.vertices[t[0]]));
  const double cells = area / (0.86602540378443865 * spacing * spacing);
  EXPECT_NEAR(static_cast<double>(m.places.size()), cells, 0.05 * cells);
  EXPECT_GT(nearestPair(m), 0.8) << "a closed border or two layers would have coincident pairs";
  ASSERT_EQ(m.notes.size(), 1u);
  EXPECT_NE(m.notes[0].find("mesh 'm': open ("), std::string::npos) << m.notes[0];
}

TEST(OpenMesh, FlatMeshesNeedNoVolume) {
  const SampledPoints m = pointsOf(quad(0.2));
  EXPECT_NEAR(static_cast<double>(m.places.size()), 115, 10);
  for (const Vec3d& n : m.normals) EXPECT_EQ(n, (Vec3d{0, 0, 1}));
  EXPECT_EQ(m.notes, std::vector<std::string>{"mesh 'm': open (4 edges at its border), kept open"});
  OrientedBody few = ofMesh("m");
  few.thin = 0.3;
  EXPECT_EQ(pointsOf(quad(0.2), few).notes, m.notes);
}

TEST(OpenMesh, RepairsAreReported) {
  TriangleMesh m = quad(0.1);
  m.vertices.push_back({0.05, 0.05, 0.1});
  m.triangles.push_back({2, 0, 4});  // at the diagonal of the quad
  EXPECT_EQ(pointsOf(m).notes,
            std::vector<std::string>{
                "mesh 'm': open (6 edges at its border), kept open, 1 edge has more than two triangles"});
  m = quad(0.1);
  std::swap(m.triangles[1][0], m.triangles[1][1]);
  EXPECT_EQ(pointsOf(m).notes,
            std::vector<std::string>{"mesh 'm': open (4 edges at its border), kept open, 1 triangle "
                                     "turned to agree with their neighbours"});
}

TEST(OpenMesh, ClosedMeshesAreSampledAsShapes) {
  TriangleMesh ball = ballMesh({}, 0.1, 0.02);
  const auto load = [&](const std::string&) { return ball; };
  const SampledPoints m = samplePoints(ofMesh("m"), spacing, 1, load),
                      shape = sampleSurface(*makeSignedDistance(ofMesh("m").shape, load), spacing, 1);
  EXPECT_EQ(m.places, shape.places);
  EXPECT_EQ(m.normals, shape.normals);
  EXPECT_TRUE(m.notes.empty());
  turnAll(ball);
  EXPECT_EQ(samplePoints(ofMesh("m"), spacing, 1, load).notes,
            std::vector<std::string>{"mesh 'm': 1 shell turned the right side out"});
}

// An exported surface can be read as a surface: its particles keep their positions.
TEST(OpenMesh, ReimportedSurfaceKeepsItsSize) {
  TriangleMesh m = quad(0.2);
  for (int k = 0; k < 3; k++) {
    const SampledPoints p = pointsOf(m);
    Vec3d low{1, 1, 0}, high{0, 0, 0};
    for (const Vec3d& x : p.places)
      for (int a = 0; a < 2; a++) low[a] = std::min(low[a], x[a]), high[a] = std::max(high[a], x[a]);
    EXPECT_LT(length(low) + length(high - Vec3d{m.vertices[2].x, m.vertices[2].y, 0}), 1.2 * spacing);
    m = quad(high.x - low.x);
  }
  EXPECT_GT(m.vertices[2].x, 0.18);
}

}  // namespace
}  // namespace thaw
