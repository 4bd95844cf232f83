// SPDX-License-Identifier: Apache-2.0
// Normals of a mesh file, from the file to the surfels.
#include "core/geometry/meshes/file_normals.hpp"

#include <gtest/gtest.h>

#include "core/geometry/meshes/mesh_normals.hpp"
#include "core/surface/seeding/sample_mesh.hpp"
#include "tests/support/meshes.hpp"

namespace thaw {
namespace {

/// A coarse ball with the exact normals of a smooth one.
TriangleMesh smoothBall(const Vec3d& centre = {}, double sign = 1) {
  TriangleMesh m = ballMesh(centre, 1, 0.5);
  for (const auto& t : m.triangles)
    m.normals.push_back({sign * normalized(m.vertices[t[0]] - centre),
                         sign * normalized(m.vertices[t[1]] - centre),
                         sign * normalized(m.vertices[t[2]] - centre)});
  return m;
}

/// Largest difference between the normals and those of a ball at their corners. NaN counts as the largest.
double worstOf(const TriangleMesh& m, const Vec3d& centre = {}) {
  double worst = m.normals.size() == m.triangles.size() ? 0 : 9;
  for (std::size_t t = 0; t < m.normals.size(); t++)
    for (std::size_t k = 0; k < 3; k++)
      worst = std::max(worst, length(m.normals[t][k] - normalized(m.vertices[m.triangles[t][k]] - centre)));
  return worst;
}

TEST(FileNormals, HaveUnitLength) {
  for (const double l : {1e-310, 1e-200, 1.0, 1e200, 1e308})
    EXPECT_NEAR(length(unitNormal({3 * (l / 5), 0, -4 * (l / 5)}) - Vec3d{0.6, 0, -0.8}), 0, 1e-10) << l;
  EXPECT_EQ(unitNormal({}), Vec3d{});
}

TEST(FileNormals, StayWithTheirCornersThroughRepairs) {
  MeshReport r;
  EXPECT_LT(worstOf(repairMesh(smoothBall(), r)), 1e-15);
  EXPECT_EQ(r.turnedNormals + r.unusedNormals, 0);
  EXPECT_EQ(describeRepairs("x", r), "");
  TriangleMesh turned = smoothBall();  // every third triangle is reversed; some of them appear twice, others
                                       // have a repeated corner
  for (std::size_t t = 0; t < turned.triangles.size(); t += 3)
    std::swap(turned.triangles[t][0], turned.triangles[t][1]),
        std::swap(turned.normals[t][0], turned.normals[t][1]);
  for (const std::size_t t : {7u, 20u})
    turned.triangles.insert(turned.triangles.begin() + 11, turned.triangles[t]),
        turned.normals.insert(turned.normals.begin() + 11, turned.normals[t]);
  turned.triangles.insert(turned.triangles.begin() + 5, {3, 3, 4}),
      turned.normals.insert(turned.normals.begin() + 5, {Vec3d{1, 0, 0}, Vec3d{1, 0, 0}, Vec3d{1, 0, 0}});
  EXPECT_LT(worstOf(repairMesh(turned, r)), 1e-15);
  EXPECT_GT(r.turnedTriangles, 10);
  EXPECT_EQ(r.turnedNormals + r.unusedNormals, 0);
}

TEST(FileNormals, AreReversedAndReportedForInvertedMeshes) {
  MeshReport r;
  TriangleMesh two = smoothBall({}, -1);  // inward, with correct triangles
  TriangleMesh other = smoothBall({3, 0, 0});
  turnAll(other);  // and outward, with reversed ones
  for (auto& n : other.normals) std::swap(n[1], n[2]);
  append(two, other);
  two.normals.insert(two.normals.end(), other.normals.begin(), other.normals.end());
  const TriangleMesh m = repairMesh(two, r);
  for (std::size_t t = 0; t < m.triangles.size(); t++)
    for (std::size_t k = 0; k < 3; k++) {
      const Vec3d x = m.vertices[m.triangles[t][k]];
      EXPECT_LT(length(m.normals[t][k] - normalized(x - Vec3d{x.x > 1.5 ? 3.0 : 0.0, 0, 0})), 1e-15);
    }
  EXPECT_EQ(r.turnedNormals, r.normals / 2);
  EXPECT_EQ(describeRepairs("x", r), "mesh 'x': 1 shell turned the right side out, " +
                                         std::to_string(r.normals / 2) + " normals turned outward");
}

TEST(FileNormals, UndefinedOnesFollowFromTrianglesAndAreReported) {
  MeshReport r;
  TriangleMesh odd = smoothBall();
  odd.normals[3][1] = {};
  odd.normals[9][2] = -odd.normals[9][2];
  // a hole: its closing triangles have no normals, which is no fault of the file
  odd.triangles.erase(odd.triangles.begin() + 30), odd.normals.erase(odd.normals.begin() + 30);
  const TriangleMesh m = repairMesh(odd, r);
  ASSERT_EQ(m.normals.size(), m.triangles.size());
  EXPECT_EQ(r.holes, 1);
  EXPECT_EQ(m.normals[3][1], Vec3d{});
  EXPECT_EQ(m.normals[9][2], Vec3d{});
  EXPECT_EQ(r.unusedNormals, 2);
  EXPECT_EQ(r.normals, 3 * static_cast<std::int64_t>(odd.triangles.size()));
  EXPECT_NE(describeRepairs("x", r).find(", 2 of its " + std::to_string(r.normals) +
                                         " normals are missing, 0 or oppose their triangle"),
            std::string::npos)
      << describeRepairs("x", r);
  TriangleMesh plain = m;
  plain.normals.clear();
  const MeshNormals with(m), without(plain);
  EXPECT_EQ(with.at(m.vertices[m.triangles[3][1]], 3), without.at(m.vertices[m.triangles[3][1]], 3));
}

/// Surfels of a coarse ball, scaled, rotated and moved, have the smooth ball's normals if the file has
/// normals.
TEST(FileNormals, AreUsedForSurfels) {
  const auto worst = [](const TriangleMesh& mesh) {
    Shape shape;
    shape.kind = ShapeKind::Mesh;
    shape.mesh = "ball";
    shape.scale = 0.25;
    shape.rotate = {0.4, -1.1, 2.5};
    shape.move = {3, 4, 5};
    double angle = 0;
    const std::vector<SurfaceSample> samples = sampleShape(
        shape, [&](const std::string&) { return mesh; }, 0.02, 1);
    EXPECT_GT(samples.size(), 1000u);
    for (const SurfaceSample& s : samples) {
      const Vec3d exact = normalized(s.position - shape.move);
      EXPECT_NEAR(length(s.normal), 1, 1e-12);
      angle = std::max(angle,
                       57.29577951308232 * std::atan2(length(cross(s.normal, exact)), dot(s.normal, exact)));
    }
    return angle;
  };
  TriangleMesh ball;  // an octahedron
  ball.vertices = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  for (const std::uint32_t x : {0u, 1u})
    for (const std::uint32_t y : {2u, 3u})
      for (const std::uint32_t z : {4u, 5u}) {
        if ((x + y + z) % 2 == 0) ball.triangles.push_back({x, y, z});
        else ball.triangles.push_back({x, z, y});
      }
  for (const auto& t : ball.triangles)
    ball.normals.push_back({ball.vertices[t[0]], ball.vertices[t[1]], ball.vertices[t[2]]});
  const double smooth = worst(ball);
  ball.normals.clear();
  const double flat = worst(ball);
  std::printf(
      "octahedron: normals of the surfels %.2g degrees off those of the ball at most, by its triangles "
      "%.3g\n",
      smooth, flat);
  EXPECT_LT(smooth, 1e-6);
  EXPECT_GT(flat, 40);
}

}  // namespace
}  // namespace thaw
