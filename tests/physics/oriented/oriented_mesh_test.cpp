// SPDX-License-Identifier: Apache-2.0
// Open meshes in a scene: used as they are by an oriented body, closed with a warning by solids, obstacles
// and constraints.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/meshes.hpp"
#include "tests/support/oriented_samples.hpp"

namespace thaw {
namespace {

/// A bowl of 0.3 m, open at the top.
TriangleMesh bowl(const std::string&) {
  TriangleMesh m = ballMesh({}, 0.3, 0.05);
  std::erase_if(m.triangles, [&](const auto& t) {
    return m.vertices[t[0]].z + m.vertices[t[1]].z + m.vertices[t[2]].z > 0;
  });
  return m;
}

Shape bowlAt(const Vec3d& x) {
  Shape s;
  s.kind = ShapeKind::Mesh;
  s.mesh = "bowl.ply";
  s.move = x;
  return s;
}

std::vector<std::string> reportsOf(const test::Simulation& x, const std::string& what) {
  std::vector<std::string> all;
  for (const SceneWarning& w : x.report.warnings)
    if (w.text.find(what) != std::string::npos) all.push_back(w.text);
  return all;
}

TEST(OrientedMesh, OpenSurfaceStartsAtRestAndStaysOpen) {
  Scene s = test::patchScene(0);
  s.domain.gravity = {};
  s.oriented[0].source = OrientedSource::Surface;
  s.oriented[0].shape = bowlAt({});
  s.oriented[0].density = 20;
  s.end = 0.05;
  test::Simulation x(s, bowl);
  EXPECT_EQ(reportsOf(x, "open (").size(), 1u);
  ASSERT_TRUE(x.run());
  const Oriented& o = x.w.oriented.rows;
  double fastest = 0, highest = -1;
  for (std::size_t i = 0; i < o.owned; i++)
    fastest = std::max(fastest, length(o.velocity[i])), highest = std::max(highest, o.position[i].z);
  EXPECT_LT(fastest, 2);  // m/s; coincident pairs would burst
  EXPECT_LT(highest, 1.5 * s.spacing) << "the opening stays open";
}

TEST(OrientedMesh, ClosedHolesOfObstaclesAndConstraintsAreReported) {
  Scene s = test::patchScene(0);
  s.oriented[0].shape.move = {0, 0, 0.2};
  OrientedConstraint a;
  a.region = bowlAt({0, 0, 0.25});
  s.oriented[0].constraints.push_back(a);
  test::addFloor(s).shape = bowlAt({0, 0, -0.3});
  test::Simulation x(s, bowl);
  const std::vector<std::string> reported = reportsOf(x, "1 hole closed (");
  ASSERT_EQ(reported.size(), 2u);
  EXPECT_EQ(reported[0].rfind("oriented body '" + s.oriented[0].name + "': a constraint: mesh 'bowl.ply'", 0),
            0u)
      << reported[0];
  EXPECT_EQ(reported[1].rfind("obstacle 'floor': mesh 'bowl.ply'", 0), 0u) << reported[1];
}

}  // namespace
}  // namespace thaw
