// SPDX-License-Identifier: Apache-2.0
// Surfaces of one solid that are closer to each other than the width of the colour field
// (docs/validation/stability.md, rows 20 and 22).
#include "core/surface/seeding/narrow_gaps.hpp"

#include <gtest/gtest.h>

#include "core/simulation/views/views.hpp"
#include "core/surface/advection/gather_particles.hpp"
#include "core/surface/field/prepare_particles.hpp"
#include "core/surface/update_components.hpp"
#include "tests/support/surface/surface_world.hpp"

namespace thaw {
namespace {

using namespace test;

/// A block of 1.2 x 0.8 x 0.6 m with a slot of `layers` particle layers at half its height, open on three
/// sides.
Scene slotted(int layers, bool solid = true) {
  Scene s = emptyScene(0.1, {-2, -2, -2}, {2, 2, 2});
  s.domain.gravity = {};
  s.materials.emplace_back();
  s.materials[0].name = "stuff";
  if (solid) s.materials[0].young = {1e5, 0};
  else s.materials[0].viscosity = {1, 1};
  s.surface.on = true;
  s.surface.source = SurfelSource::Particles;
  addBox(s, {-0.6, -0.4, -0.3}, {0.6, 0.4, 0.3});
  Shape block = s.bodies[0].shape;
  Shape& cut = s.bodies[0].shape = Shape{};
  cut.kind = ShapeKind::Difference;
  cut.parts = {block, boxOf({-0.4, -0.5, -0.05 * layers}, {0.7, 0.5, 0.05 * layers})};
  return s;
}

/// Surfels inside the slot, away from its ends, and their largest distance from its faces.
struct InSlot {
  int below = 0, above = 0;
  double off = 0;
};
InSlot lookInto(const World& w, double half) {
  InSlot in;
  for (std::size_t i = 0; i < w.surface.surfels.owned; i++) {
    const Vec3d x = w.surface.surfels.position[i], n = w.surface.surfels.normal[i];
    if (x.x < -0.2 || x.x > 0.4 || std::abs(x.y) > 0.2 || std::abs(x.z) > 0.22) continue;
    (n.z > 0 ? in.below : in.above)++;
    in.off = std::max(in.off, std::abs(std::abs(x.z) - half));
    EXPECT_GT(std::abs(n.z), 0.98);
  }
  return in;
}

TEST(NarrowGaps, SheetsOfASolidHaveSeparateSurfaces) {
  SurfaceWorld world(slotted(2));
  const std::size_t surfels = world.w.surface.surfels.owned;
  const double law = 0.6 * 0.4 / (0.05 * 0.05 * 0.866);
  const InSlot at = lookInto(world.w, 0.1);
  EXPECT_GT(at.below, 0.6 * law);
  EXPECT_GT(at.above, 0.6 * law);
  EXPECT_LT(at.off, 0.02);       // a fifth of a spacing
  for (int k = 0; k < 4; k++) {  // the block turns
    for (std::size_t i = 0; i < world.w.particles.owned; i++) {
      const Vec3d x = world.place(i);
      world.place(i) = {0.8 * x.x - 0.6 * x.z, x.y, 0.6 * x.x + 0.8 * x.z};
    }
    world.update();
    ASSERT_EQ(world.components().size(), 1u);
    EXPECT_NEAR(world.components()[0].volume / world.components()[0].particleVolume, 1, 0.01);
    EXPECT_EQ(world.w.surface.surfels.owned, surfels);
  }
}

TEST(NarrowGaps, ShellOfTwoLayersKeepsItsSurface) {  // the colour field never reaches that of a ball here, so
                                                     // that a fixed level would delete the surface
  Scene s = slotted(2);
  Shape& shell = s.bodies[0].shape;
  for (Shape& part : shell.parts) part = Shape{}, part.kind = ShapeKind::Sphere;
  shell.parts[0].radius = 0.7;
  shell.parts[1].radius = 0.5;
  SurfaceWorld world(s);
  const std::size_t surfels = world.w.surface.surfels.owned;
  for (int k = 0; k < 2; k++) world.update();
  EXPECT_EQ(world.w.surface.surfels.owned, surfels);
  ASSERT_EQ(world.components().size(), 1u);
  EXPECT_NEAR(world.components()[0].volume / world.components()[0].particleVolume, 1, 0.01);
}

TEST(NarrowGaps, AreGapsOfSolidsBelowTheFieldsResolution) {
  const auto gaps = [](const Scene& s) {
    SurfaceWorld world(s);
    gatherParticles(surfaceView(world.w), 0);
    labelParticles(surfaceView(world.w), world.ranks->halos(), world.tools);
    world.tools.relax.particlesPrepared = false;
    prepareParticles(world.w.scene, world.w.surface, world.ranks->halos(), world.tools);
    return findNarrowGaps(world.w.scene, world.w.surface, world.tools.relax.particleBins, world.all);
  };
  EXPECT_EQ(gaps(slotted(1)).solid.size(), 1u);
  EXPECT_EQ(gaps(slotted(2)).solid.size(), 1u);
  EXPECT_EQ(gaps(slotted(4)).solid.size(), 0u) << "layers are five spacings apart";
  EXPECT_EQ(gaps(slotted(2, false)).solid.size(), 0u);
  EXPECT_EQ(gaps(slotted(2, false)).liquid, std::vector<std::uint64_t>{1});
  EXPECT_EQ(SurfaceWorld(slotted(2, false)).tools.mergedSheets, std::vector<std::uint64_t>{1})
      << "a liquid gap closes, with a warning";
  Scene ball = slotted(2);
  ball.bodies[0].shape = Shape{};
  ball.bodies[0].shape.kind = ShapeKind::Sphere;
  ball.bodies[0].shape.radius = 0.7;
  EXPECT_EQ(gaps(ball).solid.size(), 0u);
  Scene bowl = ball;  // concave, but without an opposite side
  bowl.bodies[0].shape.kind = ShapeKind::Difference;
  bowl.bodies[0].shape.parts = {ball.bodies[0].shape, ball.bodies[0].shape};
  bowl.bodies[0].shape.parts[1].move = {0, 0, 0.9};
  EXPECT_EQ(gaps(bowl).solid.size(), 0u);
}

}  // namespace
}  // namespace thaw
