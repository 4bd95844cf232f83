// SPDX-License-Identifier: Apache-2.0
// Local changes of a closed mesh keep it closed and oriented.
#include "io/surface_mesh/triangle_edits.hpp"

#include <gtest/gtest.h>

#include "tests/support/closed_mesh.hpp"
#include "tests/support/meshes.hpp"

using namespace thaw;

namespace {

/// A tube of three sides along z with closed ends, and four rings of vertices.
TriangleMesh tube() {
  TriangleMesh m;
  for (int ring = 0; ring < 4; ring++)
    for (const Vec3d& x : {Vec3d{1, 0, 0}, Vec3d{-0.5, 0.8, 0}, Vec3d{-0.5, -0.8, 0}})
      m.vertices.push_back(x + Vec3d{0, 0, 1.0 * ring});
  m.vertices.push_back({0, 0, -1});
  m.vertices.push_back({0, 0, 4});
  for (std::uint32_t k = 0; k < 3; k++) {
    const std::uint32_t next = (k + 1) % 3;
    for (std::uint32_t ring = 0; ring < 3; ring++) {
      const std::uint32_t a = 3 * ring + k, b = 3 * ring + next;
      m.triangles.push_back({a, b, b + 3});
      m.triangles.push_back({a, b + 3, a + 3});
    }
    m.triangles.push_back({next, k, 12});
    m.triangles.push_back({9 + k, 9 + next, 13});
  }
  return m;
}

double volumeOfMesh(const TriangleMesh& m) {
  double sum = 0;
  for (const double v : shellVolumes(m)) sum += v;
  return sum;
}

}  // namespace

TEST(TriangleEdits, CollapseKeepsTheMeshClosed) {
  TriangleMesh m = tube();
  expectClosed(m);
  TriangleEdits edits(m);
  EXPECT_FALSE(edits.mayCollapse(3, 4)) << "an edge of a neck";
  ASSERT_TRUE(edits.mayCollapse(3, 6));
  edits.collapse(3, 6);
  EXPECT_EQ(edits.compact().size(), 13u);
  EXPECT_EQ(m.triangles.size(), 22u);
  expectClosed(m);
}

TEST(TriangleEdits, FlipExchangesTheDiagonal) {
  TriangleMesh m = tube();
  const double before = volumeOfMesh(m);
  TriangleEdits edits(m);
  const TriangleEdits::Edge e = edits.edge(3, 7);
  ASSERT_TRUE(e.found());
  ASSERT_TRUE(edits.mayFlip(3, 7, e));
  edits.flip(3, 7, e);
  EXPECT_FALSE(edits.edge(3, 7).found());
  EXPECT_TRUE(edits.edge(e.left, e.right).found());
  edits.compact();
  expectClosed(m);
  EXPECT_NEAR(volumeOfMesh(m), before, 1e-12) << "the side is flat";
}

TEST(TriangleEdits, CutOfANeckLeavesTwoClosedShells) {
  TriangleMesh m = tube();
  const double before = volumeOfMesh(m);
  TriangleEdits edits(m);
  EXPECT_EQ(edits.neckAt(3, 4), 5u);
  EXPECT_FALSE(edits.cutNeck({3, 4, 7})) << "a triangle is no neck";
  ASSERT_TRUE(edits.cutNeck({3, 4, 5}));
  edits.compact();
  EXPECT_EQ(m.vertices.size(), 17u);
  expectClosed(m);
  EXPECT_EQ(shellVolumes(m).size(), 2u);
  for (const double v : shellVolumes(m)) EXPECT_GT(v, 0);
  EXPECT_NEAR(volumeOfMesh(m), before, 1e-12);
}
