// SPDX-License-Identifier: Apache-2.0
// A mesh is read and repaired and its tree built once per start. For 100,000 triangles that takes as long as
// ten steps.
#include <gtest/gtest.h>

#include "core/simulation/setup/serial_simulation.hpp"
#include "tests/support/meshes.hpp"

namespace thaw {
namespace {

TEST(Shapes, AreBuiltOncePerBody) {
  SerialSimulation simulation;
  Scene& s = simulation.world.scene;
  s.spacing = 0.1;
  s.domain.min = {-2, -2, -2};
  s.domain.max = {2, 2, 2};
  s.materials.emplace_back();
  s.bodies.emplace_back();
  s.bodies[0].name = "ball";
  s.bodies[0].shape.kind = ShapeKind::Mesh;
  s.bodies[0].shape.mesh = "ball.ply";
  int made = 0;
  const MeshLoader load = [&](const std::string&) {
    made++;
    return ballMesh({}, 1, 0.2);
  };
  simulation.prepare(load);
  EXPECT_EQ(simulation.tools.sources.shapes.size(), 1u);
  simulation.start(load);
  EXPECT_EQ(made, 1);
  EXPECT_TRUE(simulation.tools.sources.shapes.empty()) << "they are not kept";
  EXPECT_NEAR(static_cast<double>(simulation.world.particles.owned), 4 * 3.14159 / 3 * 1000, 100);
}

}  // namespace
}  // namespace thaw
