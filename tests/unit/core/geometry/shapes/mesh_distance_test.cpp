// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/shapes/mesh_distance.hpp"

#include <gtest/gtest.h>

#include <thread>

#include "core/geometry/builtin/bust.hpp"
#include "tests/support/meshes.hpp"

namespace thaw {
namespace {

TEST(MeshDistance, EqualsThatOfABox) {
  const MeshDistance d(boxMesh({0, 0, 0}, {1, 2, 3}), "box");
  Vec3d g;
  EXPECT_DOUBLE_EQ(d.distance({0.5, 1, 0.2}, &g), -0.2);
  EXPECT_LT(length(g - Vec3d{0, 0, -1}), 1e-14);
  EXPECT_DOUBLE_EQ(d.distance({4, 1, 1}, &g), 3);
  EXPECT_LT(length(g - Vec3d{1, 0, 0}), 1e-14);
  EXPECT_DOUBLE_EQ(d.distance({-3, 6, 1}, &g), 5);
  EXPECT_LT(length(g - Vec3d{-0.6, 0.8, 0}), 1e-14);
  EXPECT_EQ(d.distance({1, 1.1, 1.2}, &g), 0);  // on a face
  EXPECT_LT(length(g - Vec3d{1, 0, 0}), 1e-14);
  EXPECT_EQ(d.bounds().max, (Vec3d{1, 2, 3}));
  EXPECT_DOUBLE_EQ(d.extent({1, 1, 0}), 3);
}

TEST(MeshDistance, WithinIsExactInItsRange) {
  const MeshDistance d(bustMesh(), "bust");
  for (std::uint64_t k = 0; k < 4000; k++) {
    const Vec3d x = randomPoint({{-0.5, -0.5, -0.2}, {0.5, 0.5, 1.2}}, k);
    const double reach = k % 2 ? 0.02 : 0.15;
    Vec3d g, h;
    const double exact = d.distance(x, &g), v = d.distanceWithin(x, reach, &h);
    ASSERT_EQ(exact < 0, v < 0);
    ASSERT_EQ(d.inside(x), exact < 0);
    ASSERT_NEAR(length(g), 1, 1e-12);
    if (std::abs(exact) < reach) {
      ASSERT_EQ(v, exact);
      ASSERT_EQ(g, h);
    } else {
      ASSERT_GE(std::abs(v), reach);
      ASSERT_LE(std::abs(v), std::abs(exact) * (1 + 1e-12));
    }
  }
}

TEST(MeshDistance, BuriedSurfacesDoNotCount) {
  TriangleMesh m = ballMesh({}, 0.8, 0.1);
  append(m, ballMesh({0.3, 0, 0}, 0.25, 0.05));  // within the large one
  append(m, ballMesh({0.9, 0, 0}, 0.3, 0.05));   // half in it
  const MeshDistance d(m, "balls");
  EXPECT_LT(d.distance({0.1, 0, 0}), -0.65);  // the small one is 0.05 away
  EXPECT_LT(d.distance({0.5, 0, 0}), -0.25);
  EXPECT_LT(d.distance({0.9, 0, 0}), -0.15);  // the large ball's surface is 0.1 away, the nearest unburied
                                              // surface 0.3
  EXPECT_NEAR(d.distance({1.4, 0, 0}), 0.2, 0.01);
  for (std::uint64_t k = 0; k < 2000; k++) {
    const Vec3d x = randomPoint({{-1, -1, -1}, {1.3, 1, 1}}, k);
    const double exact = d.distance(x), near = d.distanceWithin(x, 0.1);
    ASSERT_EQ(exact < 0, near < 0);
    if (std::abs(exact) < 0.1) { ASSERT_EQ(exact, near); }
  }
}

TEST(MeshDistance, AgreesWithBruteForce) {
  const TriangleMesh m = ballMesh({0.2, 0, 0}, 0.5, 0.08);
  const MeshDistance d(m, "ball");
  for (std::uint64_t k = 0; k < 1000; k++) {
    const Vec3d x = randomPoint({{-1, -1, -1}, {1, 1, 1}}, k);
    ASSERT_NEAR(std::abs(d.distance(x)), bruteDistance(m, x), 1e-13);
    if (bruteDistance(m, x) > 1e-9) { ASSERT_EQ(d.inside(x), bruteWinding(m, x) > 0.5); }
  }
}

TEST(MeshDistance, GradientIsTheDerivative) {
  const MeshDistance d(ballMesh({}, 0.5, 0.08), "ball");
  int checked = 0;
  for (std::uint64_t k = 0; k < 300; k++) {
    const Vec3d x = randomPoint({{-1, -1, -1}, {1, 1, 1}}, k);
    Vec3d g;
    d.distance(x, &g);
    for (int a = 0; a < 3; a++) {
      Vec3d h;
      h[a] = 1e-6;
      const double up = d.distance(x + h), down = d.distance(x - h);
      if (std::abs(up + down - 2 * d.distance(x)) > 1e-9) continue;  // a kink
      EXPECT_NEAR((up - down) / 2e-6, g[a], 1e-4);
      checked++;
    }
  }
  EXPECT_GT(checked, 700);
}

TEST(MeshDistance, LineQueriesEqualPointQueries) {
  TriangleMesh two = ballMesh({}, 0.5, 0.08), hollow = ballMesh({}, 0.6, 0.1),
               within = ballMesh({0.05, 0, 0}, 0.4, 0.1);
  append(two, ballMesh({0.4, 0.1, 0}, 0.45, 0.11));  // they overlap
  turnAll(within);
  append(hollow, within);
  const TriangleMesh meshes[] = {two, hollow, boxMesh({-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5})};
  int inside = 0, outside = 0;
  for (const TriangleMesh& mesh : meshes) {
    const MeshDistance d(mesh, "mesh");
    KnownSides known;
    for (std::uint64_t line = 0; line < 300; line++) {
      // A quarter of the lines run on the lattice of the box's faces and edges, where points lie on
      // triangles.
      const Vec3d from = line % 4 == 0 ? Vec3d{-1, 0.25 * static_cast<double>(line / 4 % 9) - 1,
                                               0.25 * static_cast<double>(line / 36) - 1}
                                       : randomPoint({{-1, -1, -1}, {1, 1, 1}}, line);
      const Vec3d step = line % 4 == 0 ? Vec3d{0.125, 0, 0}
                                       : randomPoint({{-0.1, -0.1, -0.1}, {0.1, 0.1, 0.1}}, 1000 + line);
      std::vector<Vec3d> points;
      for (int k = 0; k < 1 + static_cast<int>(line % 40); k++)
        points.push_back(from + step * static_cast<double>(k));
      std::vector<std::uint8_t> in(points.size(), 2);
      d.insideAlong(points, in, known);
      for (std::size_t k = 0; k < points.size(); k++) {
        ASSERT_EQ(in[k] != 0, d.distanceWithin(points[k], 1e-3) < 0) << "point " << k << " of line " << line;
        in[k] ? inside++ : outside++;
      }
    }
  }
  EXPECT_GT(inside, 500);
  EXPECT_GT(outside, 1000);
}

TEST(MeshDistance, IsThreadSafe) {
  const TriangleMesh mesh = ballMesh({}, 0.5, 0.05);
  const MeshDistance one(mesh, "ball"), many(mesh, "ball");
  constexpr std::size_t points = 4000, threads = 4;
  std::vector<double> found[threads];
  std::vector<std::thread> asking;
  for (std::vector<double>& f : found)
    asking.emplace_back([&] {
      for (std::uint64_t k = 0; k < points; k++)
        f.push_back(many.distanceWithin(randomPoint({{-0.6, -0.6, -0.6}, {0.6, 0.6, 0.6}}, k), 0.02));
    });
  for (std::thread& t : asking) t.join();
  for (std::uint64_t k = points; k-- > 0;)
    // independent of earlier queries
    for (const std::vector<double>& f : found)
      ASSERT_EQ(f[k], one.distanceWithin(randomPoint({{-0.6, -0.6, -0.6}, {0.6, 0.6, 0.6}}, k), 0.02));
}

TEST(Bust, IsAClosedSolidOneMetreTall) {
  const TriangleMesh m = bustMesh();
  EXPECT_GT(m.triangles.size(), 20000u);
  EXPECT_LT(m.triangles.size(), 100000u);
  MeshReport r;
  const TriangleMesh repaired = repairMesh(m, r);
  EXPECT_EQ(repaired.triangles.size(), m.triangles.size());
  EXPECT_EQ(r.shells, 1);
  EXPECT_EQ(r.holes + r.turnedShells + r.turnedTriangles, 0);
  EXPECT_GT(r.volume, 0.03);
  const MeshDistance d(m, "bust");
  EXPECT_NEAR(d.bounds().min.z, 0, 1e-12);
  EXPECT_NEAR(d.bounds().max.z, 1, 1e-12);
  EXPECT_NEAR(d.bounds().min.y, -d.bounds().max.y, 1e-12);
  EXPECT_NEAR(d.bounds().min.x, -d.bounds().max.x, 1e-3);
  EXPECT_LT(d.distance({0, 0, 0.5}), -0.03);  // inside the head, the neck, the chest
  EXPECT_EQ(bustMesh().vertices, m.vertices);
}

}  // namespace
}  // namespace thaw
