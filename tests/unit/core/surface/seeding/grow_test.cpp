// SPDX-License-Identifier: Apache-2.0
#include "core/surface/seeding/grow.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "core/simulation/views/views.hpp"
#include "core/surface/field/prepare_particles.hpp"
#include "core/surface/measures/measure.hpp"
#include "core/surface/seeding/drop_sphere.hpp"
#include "tests/unit/core/surface/surfel_rig.hpp"

namespace thaw {
namespace {

using namespace test;

void addParticles(SurfelRig& rig, double radius) {
  SurfaceParticles& p = rig.world.surface.particles;
  const double dx = rig.world.scene.spacing;
  const int n = static_cast<int>(radius / dx) + 2;
  for (int z = -n; z < n; z++)
    for (int y = -n; y < n; y++)
      for (int x = -n; x < n; x++) {
        const Vec3d at{(x + 0.5) * dx, (y + 0.5) * dx, (z + 0.5) * dx};
        if (length(at) > radius) continue;
        const std::size_t i = p.owned;
        p.resize(i + 1, 0);
        p.id[i] = i;
        p.position[i] = at;
        p.component[i] = 1;
        p.volume[i] = dx * dx * dx;
        p.liquid[i] = 1;
      }
  placeRows(rig.world.surface.grid, rig.ranks->particles, p, rig.world.surface.particleCells, rig.tools.sort);
}

TEST(Grow, CoversABallOfParticlesWithoutAHole) {
  SurfelRig rig(surfelScene(0.05));
  const double R = 0.8;
  addParticles(rig, R);
  growBodies(surfaceView(rig.world), rig.ranks->halos(), rig.tools);
  const Surfels& s = rig.surfels();
  double farthest = 0, inward = 0;
  for (std::size_t i = 0; i < s.owned; i++) {
    farthest = std::max(farthest, std::abs(length(s.position[i]) - R));
    inward = std::max(inward, 1 - dot(s.normal[i], normalized(s.position[i])));
  }
  const double hole = rig.largestHole(spherePoints(10000, R)),
               law = 4 * std::numbers::pi * R * R / (0.05 * 0.05 * std::sqrt(0.75));
  std::printf(
      "grown: %zu surfels (hexagonal %.0f), %.4f of R off it, hole %.3f spacings from the ball, normals "
      "%.4f\n",
      s.owned, law, farthest / R, hole, inward);
  EXPECT_LT(farthest, 0.05 * R);
  EXPECT_LT(inward, 0.1);
  EXPECT_LT(hole, 1.1);  // relative to the ball, which differs slightly from the surface
  EXPECT_GT(static_cast<double>(s.owned), 0.6 * law);
  EXPECT_LT(static_cast<double>(s.owned), 1.5 * law);
}

TEST(Grow, UpdatesMakeTheSurfaceOfAFewParticlesASphere) {  // stability row 21
  for (const std::size_t n : {1u, 2u, 3u, 4u}) {
    SurfelRig rig(surfelScene(0.05));
    SurfaceParticles& p = rig.world.surface.particles;
    const Vec3d all[4]{{0, 0, 0}, {0.1, 0, 0}, {0.15, 0.08, 0}, {0.1, 0.12, 0.07}};
    Vec3d middle{};
    for (std::size_t i = 0; i < n; i++) {
      p.resize(i + 1, 0);
      p.id[i] = i;
      p.position[i] = all[i];
      p.component[i] = 1;
      p.volume[i] = 1e-3;
      p.volumeRatio[i] = 1;
      p.liquid[i] = 1;
      middle += all[i] / static_cast<double>(n);
    }
    placeRows(rig.world.surface.grid, rig.ranks->particles, p, rig.world.surface.particleCells,
              rig.tools.sort);
    const double R = std::cbrt(0.75e-3 * static_cast<double>(n) / std::numbers::pi);
    for (int update = 0; update < 2; update++) {  // a new surface in each update
      measureComponents(rig.world.surface, rig.ranks->halos().all);
      renewSurfels(surfaceView(rig.world), rig.ranks->halos(), rig.tools);
      const Surfels& s = rig.surfels();
      EXPECT_GE(s.owned, 24u);
      EXPECT_LE(s.owned, 80u);
      for (std::size_t i = 0; i < s.owned; i++) EXPECT_NEAR(length(s.position[i] - middle), R, 1e-12) << n;
      placeRows(rig.world.surface.grid, rig.ranks->surfels, rig.surfels(), rig.world.surface.surfelCells,
                rig.tools.sort);
    }
  }
}

TEST(Grow, ASmallDropIsASphereOfItsVolume) {
  const double volume = 8e-6;
  const std::vector<SurfelRow> rows = dropSphere(7, {1, 2, 3}, volume, 0.01);
  const double R = std::cbrt(0.75 * volume / std::numbers::pi);
  EXPECT_GE(rows.size(), 24u);
  for (const SurfelRow& r : rows) {
    EXPECT_NEAR(length(r.position - Vec3d{1, 2, 3}), R, 1e-12);
    EXPECT_NEAR(dot(r.tangent, r.normal), 0, 1e-12);
    double nearest = 1;
    for (const SurfelRow& o : rows)
      if (o.id != r.id) nearest = std::min(nearest, length(o.position - r.position));
    EXPECT_LT(nearest, 1.1 * r.radius);
    EXPECT_GT(nearest, 0.6 * r.radius);
  }
}

}  // namespace
}  // namespace thaw
