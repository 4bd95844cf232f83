// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/setup/estimates/expected_particles.hpp"

#include <gtest/gtest.h>

#include "core/geometry/builtin/builtin_meshes.hpp"

namespace thaw {
namespace {

TEST(ExpectedArea, IsExactForBoxesAndCloseForOthers) {
  using std::numbers::pi;
  const auto areaOf = [](const Shape& s) { return expectedArea({makeSignedDistance(s)}); };
  Shape box;
  box.size = {12, 10, 6};
  EXPECT_NEAR(areaOf(box), 504, 1e-6);  // a mean over all directions would give a third less
  box.size = {16, 16, 1};
  EXPECT_NEAR(areaOf(box), 576, 1e-6);
  box.rotate = {0.3, 0.5, 0.7};
  EXPECT_NEAR(areaOf(box) / 576, 1, 0.1);
  Shape ball;
  ball.kind = ShapeKind::Sphere;
  ball.radius = 3;
  EXPECT_NEAR(areaOf(ball) / (36 * pi), 1, 0.02);
  Shape cut;
  cut.kind = ShapeKind::Difference;
  cut.parts = {box, ball};
  cut.parts[0].size = {12, 10, 8};
  cut.parts[0].rotate = {};
  EXPECT_NEAR(areaOf(cut) / (592 + 36 * pi), 1, 0.02);
  Shape bust;  // a mesh has a known area
  bust.kind = ShapeKind::Mesh;
  bust.mesh = "builtin:bust";
  EXPECT_EQ(areaOf(bust), thaw::areaOf(builtinMesh(bust.mesh)));
  bust.scale = 3;
  EXPECT_NEAR(areaOf(bust), 9 * thaw::areaOf(builtinMesh(bust.mesh)), 1e-9);
}

}  // namespace
}  // namespace thaw
