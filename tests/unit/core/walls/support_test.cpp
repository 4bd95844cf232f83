// SPDX-License-Identifier: Apache-2.0
// Walls replace the missing support of liquids: relative density at corners, pressure, drag, heat.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/heat/cover_areas.hpp"
#include "core/heat/heat.hpp"
#include "tests/support/wall_rig.hpp"

namespace thaw::test {
namespace {

struct Plane : SignedDistance {
  Vec3d n;
  double place;
  Plane(const Vec3d& normal, double at) : n(normalized(normal)), place(at) {}
  double distance(const Vec3d& x, Vec3d* g) const override {
    if (g) *g = n;
    return dot(n, x) - place;
  }
  Bounds bounds() const override { return {{-never, -never, -never}, {never, never, never}}; }
};

double densityBeside(std::initializer_list<Plane> planes) {
  WallRig r;
  for (const Plane& p : planes) r.add(std::make_shared<Plane>(p));
  r.addParticle({0, 0, 0}, {}, Liquid);
  r.start();
  r.w.particles.relativeDensity[0] = 0;
  addWallRelativeDensity({wallView(r.w), r.tables, r.liquids, 0, 0}, 1, r.contacts);
  return static_cast<double>(r.w.particles.relativeDensity[0]);
}

}  // namespace

TEST(WallRelativeDensity, CoincidingWallsCountOnce) {
  const Plane floor({0, 0, 1}, -0.05), left({1, 0, 0}, -0.05), back({0, 1, 0}, -0.05),
      ceiling({0, 0, -1}, -0.05), same({0, 0, 1}, -0.05), behind({0, 0, 1}, -0.12);
  const double one = densityBeside({floor});
  EXPECT_NEAR(densityBeside({floor, left}), 1 - (1 - one) * (1 - one), 1e-6);
  EXPECT_NEAR(densityBeside({floor, left, back}), 1 - std::pow(1 - one, 3), 2e-6);
  EXPECT_NEAR(densityBeside({floor, ceiling}), 2 * one, 1e-6);
  EXPECT_NEAR(densityBeside({floor, same}), one, 1e-6);
  EXPECT_NEAR(densityBeside({floor, behind}), one, 1e-6);
  // The shared part of two walls is a fraction of each one's contribution. The sum deviates slightly from one
  // wall, since the contribution is not linear in it.
  EXPECT_NEAR(densityBeside({behind, floor}), one, 0.01 * one);
  EXPECT_NEAR(densityBeside({behind, floor, left}), densityBeside({floor, left}), 0.01 * one);
}

// Two planes at any angle through the particle leave out angle / 2 pi. One alone contributes a fraction t of
// the half-space.
TEST(WallRelativeDensity, FollowsTheAngleBetweenWalls) {
  const double one = densityBeside({Plane({0, 0, 1}, 0)});
  for (double angle : {0.3, 1.0, 2.0, 2.9}) {
    const double both = densityBeside({Plane({0, 0, 1}, 0), Plane({std::sin(angle), 0, std::cos(angle)}, 0)});
    EXPECT_NEAR(both, one * (1 + angle / std::numbers::pi), 0.12 * one) << angle;
  }
}

TEST(WallPressure, CoincidingWallsPushOnce) {
  const auto push = [](int copies) {
    WallRig r;
    r.w.scene.domain.gravity = {};
    for (int k = 0; k < copies; k++) r.add(std::make_shared<Plane>(Vec3d{0, 0, 1}, -0.05));
    r.addParticle({0, 0, 0}, {}, Liquid);
    r.w.particles.relativeDensity[0] = 1.01f;
    r.start();
    r.w.particles.relativeDensity[0] = 1.01f;
    r.evaluate(1e-3);
    return r.w.particles.force[0].z;
  };
  EXPECT_GT(push(1), 0);
  EXPECT_NEAR(push(2), push(1), 1e-9 * push(1));
}

TEST(WallDrag, StopsWithoutOvershootAndSlipsIfRequested) {
  for (bool slip : {false, true}) {
    WallRig r;
    r.w.scene.domain.gravity = {};
    r.w.scene.materials[0].viscosity = {1e5, 1e5};  // far above the explicit limit of this step
    r.add(std::make_shared<Ground>()).slip = slip;
    r.addParticle({0, 0, 0.05}, {1, 0, 0}, Liquid);
    r.firstStep = 1e-2;
    r.start();
    const double before = r.mechanical();
    for (int k = 0; k < 20; k++) {
      r.step(1e-2);
      EXPECT_GE(r.w.particles.velocity[0].x, -1e-12);
    }
    if (slip) {
      EXPECT_EQ(r.w.particles.velocity[0].x, 1);
    } else {
      EXPECT_LT(r.w.particles.velocity[0].x, 1e-3);
      EXPECT_NEAR(r.dissipated(), before, 1e-3);
    }
  }
}

// Couette flow with a linear profile. The wall drag on a layer half a spacing above the wall equals the pull
// of the layer above, mu u / d per area.
TEST(WallDrag, IsTheShearStressOfALinearProfile) {
  WallRig r;
  r.w.scene.domain.gravity = {};
  r.w.scene.materials[0].viscosity = {2, 2};
  r.add(std::make_shared<Ground>());
  r.addParticle({0, 0, 0.05}, {0.1, 0, 0}, Liquid);
  r.addParticle({0, 0, 0.15}, {0.3, 0, 0}, Liquid);
  r.start();
  r.evaluate(1e-9);
  double drag = 0;
  for (std::size_t i = 0; i < 2; i++) drag -= r.w.particles.force[i].x;
  EXPECT_NEAR(drag, 2 * 2.0 * 0.1 * 0.1, 0.001 * 2 * 2.0 * 0.1 * 0.1);
}

TEST(WallHeat, FollowsFouriersLawWithoutOvershoot) {
  WallRig r;
  r.w.scene.domain.gravity = {};
  r.w.scene.materials[0].conductivity = {3, 3};
  Obstacle& o = r.add(std::make_shared<Ground>());
  o.temperature = 400;
  r.addParticle({0, 0, 0.05}, {}, Liquid);
  r.addParticle({0, 0, 0.15}, {}, Liquid);
  r.start();
  Continuum& p = r.w.particles;
  for (std::size_t i = 0; i < 2; i++) p.temperature[i] = 400 - 100 * p.position[i].z / 0.1;  // 1000 K/m
  addWallHeat({wallView(r.w), r.tables, r.liquids, 1e-9, 1e-9}, r.contacts);
  EXPECT_NEAR(p.heatFlow[0] + p.heatFlow[1], 3 * 1000 * 0.01, 0.06 * 30);
  EXPECT_NEAR(r.w.ledger.heatIn.value(), (p.heatFlow[0] + p.heatFlow[1]) * 1e-9, 1e-18);
  for (std::size_t i = 0; i < 2; i++) p.heatFlow[i] = 0, p.temperature[i] = 300;
  addWallHeat({wallView(r.w), r.tables, r.liquids, 1e9, 1e9}, r.contacts);
  for (std::size_t i = 0; i < 2; i++) EXPECT_LE(p.heatFlow[i] * 1e9 / (p.mass[i] * 1000), 100 * (1 + 1e-12));
  // a poor contact has all of the resistance
  r.w.walls.list[0].properties.conductance = 1e-3;
  for (std::size_t i = 0; i < 2; i++) p.heatFlow[i] = 0, p.temperature[i] = 300;
  addWallHeat({wallView(r.w), r.tables, r.liquids, 1e-9, 1e-9}, r.contacts);
  EXPECT_NEAR(p.heatFlow[0] + p.heatFlow[1], 1e-3 * 100 * 0.01, 0.3 * 1e-3);
}

TEST(WallHeat, CoincidingInsulatorTakesNoHeat) {
  const auto flow = [](int cold) {
    WallRig r;
    r.w.scene.materials[0].conductivity = {3, 3};
    r.add(std::make_shared<Ground>()).temperature = 400;
    for (int k = 0; k < cold; k++) r.add(std::make_shared<Ground>());
    r.addParticle({0, 0, 0.05}, {}, Liquid);
    r.start();
    addWallHeat({wallView(r.w), r.tables, r.liquids, 1e-6, 1e-6}, r.contacts);
    return r.w.particles.heatFlow[0];
  };
  EXPECT_EQ(flow(0), flow(1));
}

TEST(WallHeat, SurfacesOnAWallAreNotExposed) {
  WallRig r;
  r.add(std::make_shared<Ground>());
  r.addParticle({0, 0, 0.05}, {}, Liquid);
  r.start();
  r.w.particles.exposedArea[0] = 1;
  coverAreas(wallView(r.w), r.contacts);
  EXPECT_NEAR(r.w.particles.exposedArea[0], 0, 1e-3);
}

}  // namespace thaw::test
