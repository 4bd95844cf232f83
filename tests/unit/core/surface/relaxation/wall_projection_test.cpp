// SPDX-License-Identifier: Apache-2.0
// At the end of an update no surfel of any component is inside an obstacle.
#include "core/surface/relaxation/wall_projection.hpp"

#include <gtest/gtest.h>

#include "core/simulation/views/views.hpp"
#include "core/surface/advection/gather_particles.hpp"
#include "tests/support/meshes.hpp"
#include "tests/support/surface/surface_world.hpp"

namespace thaw {
namespace {

using namespace test;

/// Largest depth of a surfel inside an obstacle, over the spacing.
double deepest(const World& w) {
  double most = 0;
  for (std::size_t i = 0; i < w.surface.surfels.owned; i++)
    for (const Wall& wall : w.walls.list)
      most = std::max(most, -wall.shape->distance(toRest(wall.pose, w.surface.surfels.position[i])));
  return most / w.surface.spacing;
}

Scene aboveFloor(double young) {
  Scene s = emptyScene(0.1, {-3, -3, -1}, {3, 3, 3});
  s.materials.emplace_back();
  s.materials[0].name = "stuff";
  if (young > 0) s.materials[0].young = {young, 0};
  else s.materials[0].viscosity = {1, 1};
  s.surface.on = true;
  addFloor(s);
  return s;
}

Obstacle& addBoxObstacle(Scene& s, const Vec3d& low, const Vec3d& high) {
  s.obstacles.emplace_back();
  s.obstacles.back().name = "box";
  s.obstacles.back().shape = boxOf(low, high);
  return s.obstacles.back();
}

/// Projects particles within a quarter of a spacing of a wall off it, as a step does.
void keepParticlesOut(World& w) {
  for (std::size_t i = 0; i < w.particles.owned; i++)
    for (const Wall& wall : w.walls.list) {
      Vec3d n;
      const double d = wall.shape->distance(w.particles.position[i], &n);
      if (d < 0.25 * w.scene.spacing) w.particles.position[i] += (0.25 * w.scene.spacing - d) * n;
    }
}

TEST(WallProjection, HoldsForLiquidThatFlattensAroundAPeg) {
  Scene s = aboveFloor(0);
  addBox(s, {-0.4, -0.4, 0.1}, {0.4, 0.4, 0.8});
  addBoxObstacle(s, {0.05, -0.1, 0}, {0.25, 0.1, 0.09});
  SurfaceWorld world(s);
  for (int k = 0; k < 12; k++) {
    for (std::size_t i = 0; i < world.w.particles.owned; i++) {
      Vec3d& x = world.place(i);
      x = {1.08 * x.x, 1.08 * x.y, x.z / (1.08 * 1.08)};
    }
    keepParticlesOut(world.w);
    world.update();
    EXPECT_LT(deepest(world.w), 0.05) << "update " << k;
  }
  std::int64_t onFloor = 0;
  for (std::size_t i = 0; i < world.w.surface.surfels.owned; i++)
    onFloor += world.w.surface.surfels.position[i].z < 1e-3;
  EXPECT_GT(onFloor, 200);  // and there is a surface on it
  for (const SurfaceComponent& c : world.components()) {
    if (c.particles > 12) { EXPECT_NEAR(c.volume / c.particleVolume, 1, 0.01); }
  }
}

TEST(WallProjection, HoldsForDropsOfAFewParticles) {
  Scene s = aboveFloor(0);
  addBox(s, {-0.1, -0.1, 0}, {0, 0, 0.1});  // one particle
  addBox(s, {0.5, 0, 0}, {0.7, 0.2, 0.1});  // four
  SurfaceWorld world(s);
  for (int k = 0; k < 3; k++) {
    for (std::size_t i = 0; i < world.w.particles.owned; i++) world.place(i).z -= 0.01;
    world.update();
    ASSERT_EQ(world.components().size(), 2u);
    EXPECT_LT(deepest(world.w), 0.05);
    for (const SurfaceComponent& c : world.components())
      EXPECT_NEAR(c.volume / c.particleVolume, 1, 0.02) << c.particles << " particles";
  }
}

TEST(WallProjection, DippingSolidsKeepTheirShape) {
  Scene s = aboveFloor(1e5);
  Body& bar = addBox(s, {-0.4, -0.4, 0.05}, {0.4, 0.4, 0.65});
  bar.shape = Shape{}, bar.shape.kind = ShapeKind::Mesh, bar.shape.mesh = "bar";
  SurfaceWorld world(s, [](const std::string&) { return boxMesh({-0.4, -0.4, 0.05}, {0.4, 0.4, 0.65}); });
  const auto lowest = [&] {
    double z = 1;
    for (std::size_t i = 0; i < world.w.surface.surfels.owned; i++)
      z = std::min(z, world.w.surface.surfels.position[i].z);
    return z;
  };
  const double before = lowest();
  const auto move = [&](double by) {
    for (std::size_t i = 0; i < world.w.particles.owned; i++) world.place(i).z += by;
    world.update();
  };
  move(-0.09);
  EXPECT_LT(deepest(world.w), 0.05);
  move(-0.01);
  EXPECT_LT(deepest(world.w), 0.05);
  move(0.1);
  EXPECT_NEAR(lowest(), before, 1e-9);
}

TEST(WallProjection, NothingComesThroughAThinWall) {
  Scene s = aboveFloor(0);
  s.obstacles.clear();
  addBox(s, {-0.4, -0.4, 0.01}, {0.4, 0.4, 0.61});
  addBoxObstacle(s, {-1, -1, -0.06}, {1, 1, 0});
  SurfaceWorld world(s);
  Surfels& f = world.w.surface.surfels;
  std::int64_t through = 0;
  for (std::size_t i = 0; i < f.owned; i++)
    if (f.normal[i].z < -0.9) f.position[i].z = -0.07, through++;  // beyond the wall
  ASSERT_GT(through, 50);
  gatherParticles(surfaceView(world.w), 0);
  const SurfaceParticles& p = world.w.surface.particles;
  Bins bins;
  fillBins(p.position.data(), p.owned, 0.1, bins);
  projectOutOfWalls(surfaceView(world.w), bins);
  for (std::size_t i = 0; i < f.owned; i++) EXPECT_GT(f.position[i].z, -0.01);
  EXPECT_LT(deepest(world.w), 0.05);
}

/// A liquid that has expanded in all directions to twice its volume. tests/output/torn_film_test.sh covers
/// tearing.
TEST(WallProjection, TornFilmsKeepTheirVolume) {
  Scene s = aboveFloor(0);
  addBox(s, {-0.6, -0.6, 0.0}, {0.6, 0.6, 0.2});
  SurfaceWorld world(s);
  for (int k = 0; k < 12; k++) {
    for (std::size_t i = 0; i < world.w.particles.owned; i++) {
      Vec3d& x = world.place(i);
      x = {1.022 * x.x, 1.022 * x.y, 1.02 * x.z};
    }
    world.update();
    EXPECT_LT(deepest(world.w), 0.05);
  }
  for (int k = 0; k < 3; k++) world.update();
  ASSERT_EQ(world.components().size(), 1u);
  const SurfaceComponent& c = world.components()[0];
  EXPECT_NEAR(c.volume / c.particleVolume, 1, 0.01);
  EXPECT_LT(c.open, 0.03);
}

/// A few particles in a flat drop: below them the colour falls off to the side. They are too far apart for a
/// level with their volume, so that offsets draw the surface in.
TEST(WallProjection, FlatDropsKeepTheirFloor) {
  for (const double apart : {1.0, 1.3}) {
    Scene s = aboveFloor(0);
    addBox(s, {-0.1, -0.1, 0}, {0.1, 0.2, 0.1});  // six
    SurfaceWorld world(s);
    std::vector<Vec3d> start;
    for (std::size_t i = 0; i < world.w.particles.owned; i++) start.push_back(world.place(i));
    ASSERT_EQ(start.size(), 6u);
    for (int k = 1; k <= 12; k++) {
      const double share = std::min(1.0, k / 6.0), wide = 1 + (apart - 1) * share;
      for (std::size_t i = 0; i < start.size(); i++)
        world.place(i) = {wide * start[i].x, wide * start[i].y, 0.05 - 0.025 * share};
      world.update();
      ASSERT_EQ(world.components().size(), 1u);
      const SurfaceComponent& c = world.components()[0];
      EXPECT_LT(c.open, 0.05) << "update " << k << ", " << apart << " spacings apart";
      EXPECT_NEAR(c.volume / c.particleVolume, 1, 0.01)
          << "update " << k << ", " << apart << " spacings apart";
      EXPECT_LT(deepest(world.w), 0.05);
    }
  }
}

}  // namespace
}  // namespace thaw
