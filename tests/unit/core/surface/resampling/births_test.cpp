// SPDX-License-Identifier: Apache-2.0
// Surfels that are born on a solid that bends, melts or tears.
#include "core/surface/resampling/births.hpp"

#include <gtest/gtest.h>

#include "core/surface/advection/reference_motion.hpp"
#include "tests/unit/core/surface/surfel_rig.hpp"

namespace thaw {
namespace {

using test::SurfelRig;

/// A flat sheet of surfels 0.1 apart that follow their initial positions, stretched, sheared and rotated
/// since.
struct Stretched {
  SurfelRig rig{test::surfelScene(0.1)};
  Mat3d map{};
  explicit Stretched(const Mat3d& by) : map(by) {
    Surfels& s = rig.surfels();
    const Vec3d n = normalized(cross(by * Vec3d{1, 0, 0}, by * Vec3d{0, 1, 0}));
    for (int i = -4; i <= 4; i++)
      for (int j = -4; j <= 4; j++) rig.add(by * Vec3d{0.1 * i, 0.1 * j, 0}, n);
    s.activate(s.hasReference);
    s.activate(s.referencePosition);
    s.activate(s.referenceNormal);
    s.activate(s.referenceTangent);
    const Mat3d back = inverse(by);
    for (std::size_t i = 0; i < s.owned; i++) {
      s.hasReference[i] = 1;
      s.referencePosition[i] = back * s.position[i];
      s.referenceNormal[i] = {0, 0, 1};
      s.referenceTangent[i] = {1, 0, 0};
      s.tangent[i] = normalized(by * Vec3d{1, 0, 0});
    }
  }
  SurfelRow bornAt(const Vec3d& start) {
    const Surfels& s = rig.surfels();
    Patch patch;
    patch.surfels = &s;
    patch.centre = s.owned / 2;
    for (std::uint32_t j = 0; j < s.owned; j++)
      if (j != patch.centre && length(s.position[j] - s.position[patch.centre]) < 0.3)
        patch.rows.push_back(j);
    return blendedSurfel(patch, {map * start, s.normal[patch.centre]});
  }
};

// The reference position of a newborn includes the strain of its surroundings. Otherwise the next update
// moves the newborn by the strain times its distance from the parent.
TEST(Births, NewbornsGetTheInitialPositionOfTheUndeformedSheet) {
  const Mat3d turned{{{0.6, 0, 0.8}, {0, 1, 0}, {-0.8, 0, 0.6}}},
      strained{{{2.1, 0.7, 0}, {-0.3, 0.8, 0}, {0, 0, 1}}};
  Stretched sheet(turned * strained);
  for (const Vec3d& start : {Vec3d{0.04, 0.03, 0}, Vec3d{-0.05, 0.05, 0}, Vec3d{0.02, -0.06, 0}}) {
    const SurfelRow born = sheet.bornAt(start);
    ASSERT_TRUE(born.hasReference);
    EXPECT_LT(length(born.referencePosition - start), 1e-12);
  }
}

// Half-molten surfels keep a distance from the particles' surface by their detail height. Newborns that
// relaxed fully would be detached below or above the sheet.
TEST(Births, NewbornsRelaxLikeTheirNeighbours) {
  SurfelRig rig(test::surfelScene(0.1));
  Surfels& s = rig.surfels();
  s.activate(s.liquid);
  s.activate(s.carried);
  s.activate(s.carriedNormal);
  rig.add({0, 0, 0.3}, {0, 0, 1});
  EXPECT_EQ(s.carried[0], (Vec3d{0, 0, 0.3}));
  EXPECT_EQ(s.carriedNormal[0], (Vec3d{0, 0, 1}));
  s.activate(s.relaxesOnce);  // the face of a crack relaxes
  rig.add({0.1, 0, 0.3}, {0, 0, 1});
  EXPECT_EQ(s.relaxesOnce[1], 1);
  EXPECT_EQ(s.carriedNormal[1], Vec3d{});
}

// Newborns at the start are projected onto the body: the mean plane of two faces lies on neither.
TEST(Births, AtTheStartAreOnTheMesh) {
  Scene scene = test::surfelScene(0.1);
  scene.bodies.emplace_back();
  scene.bodies[0].shape.kind = ShapeKind::Mesh;
  scene.bodies[0].shape.mesh = "cube";
  TriangleMesh cube = boxMesh({-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5});
  SurfelRig rig(scene);
  rig.add({0.46, 0.1, 0.46}, normalized(Vec3d{1, 0, 1.2}), 1);
  Surfels& s = rig.surfels();
  s.id[0] |= birthBit;
  putBirthsOnShapes(rig.world.scene, rig.world.surface, [&](const std::string&) { return cube; });
  EXPECT_LT(length(s.position[0] - Vec3d{0.46, 0.1, 0.5}) * length(s.position[0] - Vec3d{0.5, 0.1, 0.46}),
            1e-12);
  EXPECT_GT(std::max(s.normal[0].x, s.normal[0].z), 1 - 1e-12);
}

}  // namespace
}  // namespace thaw
