// SPDX-License-Identifier: Apache-2.0
#include "core/surface/surfel_velocities.hpp"

#include "tests/support/surface/surface_world.hpp"

using namespace thaw;
using namespace thaw::test;

namespace {

Scene ballOfWater() {
  Scene s;
  s.spacing = 0.1;
  s.domain.min = {-1, -1, -1};
  s.domain.max = {1, 1, 1};
  s.materials.resize(1);
  s.materials[0].density = 1000;
  s.materials[0].soundSpeed = 20;
  s.bodies.resize(1);
  s.bodies[0].shape.kind = ShapeKind::Sphere;
  s.bodies[0].shape.radius = 0.5;
  s.surface.on = true;
  return s;
}

}  // namespace

TEST(SurfelVelocities, AffineFieldsAreExact) {
  SurfaceWorld world(ballOfWater());
  const Mat3d g{{{0.1, -0.2, 0.05}, {0.15, 0.02, 0.1}, {-0.1, 0.07, -0.05}}};
  const Vec3d t{0.3, -0.4, 0.1};
  Continuum& p = world.w.particles;
  for (std::size_t i = 0; i < p.owned; i++) p.velocity[i] = g * p.position[i] + t;
  const auto check = [&] {
    const Surfels& s = world.w.surface.surfels;
    const std::vector<Vec3d> v = surfelVelocities(surfaceView(world.w), world.ranks->halos(), world.tools);
    ASSERT_GT(s.owned, 100u);
    ASSERT_EQ(v.size(), s.owned);
    for (std::size_t i = 0; i < v.size(); i++) EXPECT_LT(length(v[i] - g * s.position[i] - t), 1e-12);
    EXPECT_EQ(world.w.surface.particles.size(), 0u);
  };
  check();
  for (std::size_t i = 0; i < p.owned; i++) p.position[i] += Vec3d{0.02, 0, 0.01};
  world.update();
  for (std::size_t i = 0; i < p.owned; i++) p.velocity[i] = g * p.position[i] + t;
  check();
}

// The next update has the same bits as without velocities.
TEST(SurfelVelocities, ChangeNoLaterUpdate) {
  SurfaceWorld with(ballOfWater()), without(ballOfWater());
  for (SurfaceWorld* world : {&with, &without}) {
    if (world == &with) surfelVelocities(surfaceView(world->w), world->ranks->halos(), world->tools);
    Continuum& p = world->w.particles;
    for (std::size_t i = 0; i < p.owned; i++) p.position[i] += 0.03 * p.position[i].x * Vec3d{1, 0.2, 0};
    world->update();
  }
  const Surfels &a = with.w.surface.surfels, &b = without.w.surface.surfels;
  ASSERT_EQ(a.owned, b.owned);
  for (std::size_t i = 0; i < a.owned; i++) {
    EXPECT_EQ(a.id[i], b.id[i]);
    EXPECT_EQ(a.position[i], b.position[i]);
    EXPECT_EQ(a.normal[i], b.normal[i]);
  }
}
