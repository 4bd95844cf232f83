// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/sampling/blue_noise.hpp"
#include "core/geometry/meshes/mesh_normals.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <ctime>
#include <numbers>

#include "core/geometry/builtin/bust.hpp"
#include "core/surface/seeding/sample_mesh.hpp"
#include "tests/support/meshes.hpp"

namespace thaw {
namespace {

struct Spread {
  double least = 1e300, mean = 0, hole = 0;
};  // over the spacing

/// Brute-force nearest-sample distances on each side: between samples, and from many points of the mesh.
Spread spreadOf(const TriangleMesh& mesh, const std::vector<MeshSample>& s, double spacing) {
  const auto normal = [&](std::uint32_t t) {
    const auto& c = mesh.triangles[t];
    return normalized(
        cross(mesh.vertices[c[1]] - mesh.vertices[c[0]], mesh.vertices[c[2]] - mesh.vertices[c[0]]));
  };
  Spread r;
  for (std::size_t i = 0; i < s.size(); i++) {
    double d = 1e300;
    for (std::size_t j = 0; j < s.size(); j++)
      if (i != j && dot(normal(s[i].triangle), normal(s[j].triangle)) > 0)
        d = std::min(d, length(s[i].position - s[j].position));
    r.least = std::min(r.least, d / spacing);
    r.mean += d / spacing / static_cast<double>(s.size());
  }
  std::uint64_t draw = 0;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); t++) {
    const auto& c = mesh.triangles[t];
    const Vec3d a = mesh.vertices[c[0]], b = mesh.vertices[c[1]], o = mesh.vertices[c[2]];
    const int points = 1 + static_cast<int>(60 * 0.5 * length(cross(b - a, o - a)) / (spacing * spacing));
    for (int k = 0; k < points; k++) {
      double u = randomUniform(1, Purpose::Test, draw++), v = randomUniform(1, Purpose::Test, draw++);
      if (u + v > 1) u = 1 - u, v = 1 - v;
      const Vec3d x = a + u * (b - a) + v * (o - a);
      double d = 1e300;
      for (const MeshSample& m : s)
        if (dot(normal(m.triangle), normal(t)) > -0.3) d = std::min(d, length(m.position - x));
      r.hole = std::max(r.hole, d / spacing);
    }
  }
  return r;
}

TEST(BlueNoise, LeavesNoHoleAndNoCrowdOnABall) {
  const TriangleMesh ball = ballMesh({}, 1, 0.11);
  const double spacing = 0.1;
  const std::vector<MeshSample> s = blueNoise(ball, spacing, 1);
  const Spread r = spreadOf(ball, s, spacing);
  const double hexagonal = 4 * std::numbers::pi / (spacing * spacing * std::sqrt(0.75));
  std::printf("ball: %zu places (hexagonal %.0f), least %.3f, mean %.3f, largest hole %.3f\n", s.size(),
              hexagonal, r.least, r.mean, r.hole);
  EXPECT_GT(r.least, 0.6);
  EXPECT_GT(r.mean, 0.8);
  EXPECT_LT(r.hole, 0.95);
  EXPECT_NEAR(static_cast<double>(s.size()), hexagonal, 0.1 * hexagonal);
  const std::vector<MeshSample> again = blueNoise(ball, spacing, 1);
  ASSERT_EQ(again.size(), s.size());
  for (std::size_t k = 0; k < s.size(); k++) EXPECT_EQ(again[k].position, s[k].position);
}

TEST(BlueNoise, CoversLargeTrianglesSliversAndThinPlates) {
  const double spacing = 0.1;
  for (const TriangleMesh& mesh :
       {boxMesh({}, {1, 1, 1}), boxMesh({}, {1, 1, 0.02}), boxMesh({}, {2, 0.03, 0.03})}) {
    const std::vector<MeshSample> s = blueNoise(mesh, spacing, 2);
    const Spread r = spreadOf(mesh, s, spacing);
    std::printf("box: %zu places, least %.3f, mean %.3f, largest hole %.3f\n", s.size(), r.least, r.mean,
                r.hole);
    EXPECT_LT(r.hole, 1.0);
    EXPECT_GT(r.least, 0.3);
  }
}

TEST(BlueNoise, SamplesTheBustOntoTheSculpture) {
  Shape shape;
  shape.kind = ShapeKind::Mesh;
  shape.mesh = builtinBust;
  const TriangleMesh mesh = bustMesh();
  const double spacing = 0.0055;
  const std::clock_t t0 = std::clock();
  const std::vector<MeshSample> s = blueNoise(mesh, spacing, 1);
  const std::clock_t t1 = std::clock();
  const std::vector<SurfaceSample> all = sampleShape(shape, {}, spacing, 1);
  const std::clock_t t2 = std::clock();
  std::printf("bust: %zu triangles, %zu samples in %.3f s of CPU; as a body in %.3f s\n",
              mesh.triangles.size(), s.size(), static_cast<double>(t1 - t0) / CLOCKS_PER_SEC,
              static_cast<double>(t2 - t1) / CLOCKS_PER_SEC);
  ASSERT_EQ(all.size(), s.size());
  double worst = 0;
  for (const SurfaceSample& x : all) {
    EXPECT_NEAR(length(x.normal), 1, 1e-12);
    worst = std::max(worst, std::abs(bustValue(x.position)));
  }
  EXPECT_LT(worst, 0.0025);
}

TEST(BlueNoise, NormalsOfSliversAreThoseOfTheirSurroundings) {
  double mean = 0, worst = 0, n = 0;
  for (const double cell : {0.07, 0.083, 0.1}) {
    const Vec3d centre{0.013, 0.007, 0.0031};
    const TriangleMesh ball = ballMesh(centre, 1, cell);
    const MeshNormals normals(ball);
    for (const MeshSample& s : blueNoise(ball, 0.03, 5)) {
      const Vec3d exact = normalized(s.position - centre), found = normals.at(s.position, s.triangle);
      const double angle = 57.29577951308232 * std::atan2(length(cross(found, exact)), dot(found, exact));
      mean += angle;
      worst = std::max(worst, angle);
      n++;
    }
  }
  std::printf("normals: %.3f degrees in the mean, %.3f at most, of %.0f\n", mean / n, worst, n);
  EXPECT_LT(mean / n, 0.85);  // without slivers' corrections 0.856 and 53.4
  EXPECT_LT(worst, 10);
}

}  // namespace
}  // namespace thaw
