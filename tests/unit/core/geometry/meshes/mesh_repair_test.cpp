// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/meshes/mesh_repair.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <set>

#include "core/geometry/basic/shape_error.hpp"
#include "core/geometry/meshes/mesh_edges.hpp"
#include "core/geometry/shapes/mesh_distance.hpp"
#include "tests/support/meshes.hpp"

namespace thaw {
namespace {

bool balanced(const TriangleMesh& m) {
  bool good = true;
  const auto sides = edgeSides(m);
  forEachEdge(sides, [&](std::size_t first, std::size_t last) {
    int net = 0;
    for (std::size_t k = first; k < last; k++) net += sides[k].sign;
    good = good && net == 0;
  });
  return good;
}

/// Number of points that are classified differently from `expected`. Points near its surface are left out.
template<class F> int wrong(const TriangleMesh& m, const Bounds& b, F&& expected) {
  const MeshDistance d(m, "test");
  int n = 0;
  for (std::uint64_t k = 0; k < 3000; k++) {
    const Vec3d x = randomPoint(b, 100 + k);
    const double e = expected(x);
    if (std::abs(e) > 0.03) n += d.inside(x) != (e < 0);
  }
  return n;
}

const Bounds around{{-1.2, -1.2, -1.2}, {1.2, 1.2, 1.2}};
double ball(const Vec3d& x) { return length(x) - 0.8; }
double shell(const Vec3d& x) { return std::max(length(x) - 0.8, 0.4 - length(x)); }

TEST(MeshRepair, KeepsAValidMesh) {
  MeshReport r;
  const TriangleMesh m = ballMesh({}, 0.8, 0.1), good = repairMesh(m, r);
  EXPECT_EQ(good.triangles.size(), m.triangles.size());
  EXPECT_EQ(good.vertices.size(), m.vertices.size());
  EXPECT_EQ(r.shells, 1);
  EXPECT_EQ(r.holes + r.turnedTriangles + r.turnedShells, 0);
  EXPECT_EQ(describeRepairs("x", r), "");
  EXPECT_NEAR(r.volume, volumeOf(m), 1e-12);
}

TEST(MeshRepair, ReversesInvertedTriangles) {
  TriangleMesh m = ballMesh({}, 0.8, 0.1);
  turnAll(m);
  EXPECT_EQ(wrong(m, around, ball), 0);
  // and every third again
  for (std::size_t t = 0; t < m.triangles.size(); t += 3) std::swap(m.triangles[t][0], m.triangles[t][1]);
  EXPECT_EQ(wrong(m, around, ball), 0);
  MeshReport r;
  EXPECT_TRUE(balanced(repairMesh(m, r)));
  EXPECT_GT(r.turnedTriangles, 0);
  EXPECT_NE(describeRepairs("x", r).find("triangles turned"), std::string::npos);
}

TEST(MeshRepair, ReversesOneOfTwoBalls) {
  TriangleMesh m = ballMesh({-0.6, 0, 0}, 0.4, 0.05), other = ballMesh({0.6, 0, 0}, 0.4, 0.05);
  turnAll(other);
  append(m, other);
  const auto both = [](const Vec3d& x) {
    return std::min(length(x - Vec3d{-0.6, 0, 0}), length(x - Vec3d{0.6, 0, 0})) - 0.4;
  };
  EXPECT_EQ(wrong(m, around, both), 0);
  MeshReport r;
  repairMesh(m, r);
  EXPECT_EQ(r.turnedShells, 1);
  EXPECT_EQ(r.shells, 2);
}

TEST(MeshRepair, KeepsCavities) {
  TriangleMesh outer = ballMesh({}, 0.8, 0.08), inner = ballMesh({}, 0.4, 0.08), m = inner;
  turnAll(m);
  append(m, outer);
  EXPECT_EQ(wrong(m, around, shell), 0);
  turnAll(m);  // the whole inside out
  EXPECT_EQ(wrong(m, around, shell), 0);
  append(outer, inner);  // a solid in a solid
  EXPECT_EQ(wrong(outer, around, ball), 0);
}

TEST(MeshRepair, ClosesSmallHoles) {
  TriangleMesh m = ballMesh({}, 0.8, 0.1);
  std::set<std::size_t> missing;
  for (std::uint64_t k = 0; missing.size() < 30; k++)
    missing.insert(randomBits(1, Purpose::Test, k) % m.triangles.size());
  TriangleMesh holed{m.vertices, {}};
  for (std::size_t t = 0; t < m.triangles.size(); t++)
    if (!missing.count(t)) holed.triangles.push_back(m.triangles[t]);
  MeshReport r;
  EXPECT_TRUE(balanced(repairMesh(holed, r)));
  EXPECT_GT(r.holes, 20);
  EXPECT_EQ(wrong(holed, around, ball), 0);
}

TEST(MeshRepair, ClosesALargeOpening) {
  TriangleMesh m = boxMesh({-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5});
  m.triangles.erase(m.triangles.begin() + 2, m.triangles.begin() + 4);  // no lid
  const auto box = [](const Vec3d& x) {
    return std::max({std::abs(x.x), std::abs(x.y), std::abs(x.z)}) - 0.5;
  };
  EXPECT_EQ(wrong(m, around, box), 0);
  MeshReport r;
  repairMesh(m, r);
  EXPECT_EQ(r.holes, 1);
  EXPECT_NEAR(r.holeArea, 1, 1e-12);
  EXPECT_NEAR(r.volume, 1, 1e-12);
}

TEST(MeshRepair, SelfIntersectionsAreInside) {
  TriangleMesh m = boxMesh({-0.8, -0.3, -0.3}, {0.2, 0.3, 0.3});
  append(m, boxMesh({-0.2, -0.2, -0.5}, {0.8, 0.2, 0.5}));
  const auto both = [](const Vec3d& x) {
    const double a = std::max({x.x - 0.2, -0.8 - x.x, std::abs(x.y) - 0.3, std::abs(x.z) - 0.3}),
                 b = std::max({x.x - 0.8, -0.2 - x.x, std::abs(x.y) - 0.2, std::abs(x.z) - 0.5});
    return std::min(a, b);
  };
  EXPECT_EQ(wrong(m, around, both), 0);
}

TEST(MeshRepair, MergesDuplicateVertices) {
  TriangleMesh m = ballMesh({}, 0.8, 0.1), apart, noisy;
  for (const auto& t : m.triangles)
    for (const std::uint32_t v : t) {
      apart.vertices.push_back(m.vertices[v]);
      noisy.vertices.push_back(m.vertices[v] + 1e-7 * randomPoint(around, noisy.vertices.size()));
    }
  for (std::uint32_t t = 0; t < m.triangles.size(); t++)
    apart.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
  noisy.triangles = apart.triangles;
  MeshReport r;
  EXPECT_EQ(repairMesh(apart, r).vertices.size(), m.vertices.size());
  EXPECT_EQ(r.holes, 0);
  EXPECT_TRUE(balanced(repairMesh(noisy, r)));
  EXPECT_EQ(r.holes, 0);
  EXPECT_EQ(wrong(noisy, around, ball), 0);
  TriangleMesh twice = m;
  append(twice, m);
  EXPECT_EQ(repairMesh(twice, r).triangles.size(), m.triangles.size());
  turnAll(m);
  append(twice, m);  // both sides written out
  EXPECT_EQ(wrong(twice, around, ball), 0);
}

TEST(MeshRepair, TriangleSoupHasAnInside) {
  TriangleMesh m = ballMesh({}, 0.8, 0.1), apart;
  for (const auto& t : m.triangles) {
    const Vec3d middle = (m.vertices[t[0]] + m.vertices[t[1]] + m.vertices[t[2]]) / 3.0;
    for (const std::uint32_t v : t) apart.vertices.push_back(middle + (m.vertices[v] - middle) * 0.97);
    const auto n = static_cast<std::uint32_t>(apart.vertices.size());
    apart.triangles.push_back({n - 3, n - 1, n - 2});
  }
  MeshReport r;
  repairMesh(apart, r);
  EXPECT_FALSE(r.closed);
  EXPECT_EQ(wrong(apart, around, ball), 0);
}

TEST(MeshRepair, MoebiusStripDoesNotHang) {
  TriangleMesh m;
  const int n = 40;
  for (int k = 0; k < n; k++) {
    const double a = 6.283185307179586 * k / n;
    for (double s : {-0.2, 0.2})
      m.vertices.push_back({(1 + s * std::cos(a / 2)) * std::cos(a), (1 + s * std::cos(a / 2)) * std::sin(a),
                            s * std::sin(a / 2)});
  }
  for (std::uint32_t k = 0; k < n; k++) {
    const std::uint32_t a = 2 * k, b = 2 * k + 1, c = k + 1 < n ? a + 2 : 1, d = k + 1 < n ? a + 3 : 0;
    m.triangles.push_back({a, b, c});
    m.triangles.push_back({b, d, c});
  }
  MeshReport r;
  try {
    EXPECT_TRUE(balanced(repairMesh(m, r)));
  } catch (const ShapeError&) {  // an error about zero volume is allowed
  }
}

TEST(MeshRepair, ErrorsNameTheProblem) {
  const auto message = [](const TriangleMesh& m) -> std::string {
    MeshReport r;
    try {
      repairMesh(m, r);
    } catch (const ShapeError& e) { return e.what(); }
    return "none";
  };
  EXPECT_NE(message({}).find("no triangles"), std::string::npos);
  TriangleMesh m = boxMesh({0, 0, 0}, {1, 1, 1});
  m.triangles[3][1] = 8;
  EXPECT_NE(message(m).find("triangle 3 refers to vertex 8, but the mesh has 8"), std::string::npos);
  m = boxMesh({0, 0, 0}, {1, 1, 1});
  m.vertices[2].y = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(message(m).find("finite"), std::string::npos);
  m.vertices[2].y = std::numeric_limits<double>::infinity();
  EXPECT_NE(message(m).find("finite"), std::string::npos);
  EXPECT_NE(message(boxMesh({0, 0, 0}, {1, 1, 0})).find("no volume"), std::string::npos);
  m = boxMesh({0, 0, 0}, {1, 1, 1});
  m.triangles.resize(1);
  EXPECT_NE(message(m).find("no volume"), std::string::npos);
  for (auto& v : m.vertices) v = {};
  EXPECT_NE(message(m).find("equal corners"), std::string::npos);
}

}  // namespace
}  // namespace thaw
