// SPDX-License-Identifier: Apache-2.0
#include "core/surface/measures/facets.hpp"

#include <gtest/gtest.h>

#include "core/surface/measures/measure.hpp"
#include "core/surface/measures/surfel_area.hpp"
#include "core/surface/seeding/drop_sphere.hpp"
#include "tests/unit/core/surface/surfel_rig.hpp"

namespace thaw {
namespace {

using test::SurfelRig;
using test::surfelScene;

using std::numbers::pi;

SurfaceComponent measured(SurfelRig& rig) {
  Surface& s = rig.world.surface;
  placeRows(s.grid, rig.ranks->surfels, s.surfels, s.surfelCells, rig.tools.sort);
  AreaLists lists;
  findSurfelAreas(s, rig.ranks->halos().all, lists);
  measureComponents(s, rig.ranks->halos().all);
  return s.components.at(0);
}

/// Volume as the sum x.n A / 3.
double byNormals(const Surfels& f) {
  double volume = 0;
  for (std::size_t i = 0; i < f.owned; i++) volume += dot(f.position[i], f.normal[i]) * f.area[i] / 3;
  return volume;
}

}  // namespace

TEST(Facets, VolumesOfSmallDropsAreExact) {
  for (const double particles : {1.0, 2.0, 3.0, 4.0, 20.0}) {
    const double volume = particles * 1e-3;
    SurfelRig rig(surfelScene(0.05));
    appendSurfels(rig.surfels(), dropSphere(1, {0.3, -0.2, 0.1}, volume, 0.05));
    const SurfaceComponent c = measured(rig);
    EXPECT_NEAR(c.volume, volume, 2e-3 * volume) << c.surfels << " surfels";
    EXPECT_LT(c.open, 0.01);
  }
}

// A film with a round rim whose smoothed normals begin to turn two spacings before it. Most of sum x.n A
// belongs to the rim.
TEST(Facets, VolumeOfAFilmWithSmoothNormalsIsExact) {
  const double d = 0.05, t = 0.06, R = 1;
  SurfelRig rig(surfelScene(d));
  for (int y = -30; y <= 30; y++)
    for (int x = -30; x <= 30; x++)
      for (int side = -1; side <= 1; side += 2) {
        const int key = 200 * (y + 40) + 2 * (x + 40) + side;
        const auto noise = [&](std::uint64_t k) {
          return 0.15 * d * (2 * randomUniform(5, Purpose::Test, static_cast<std::uint64_t>(key), k) - 1);
        };
        const Vec3d at{d * (x + 0.5 * (y & 1)) + noise(0), 0.8660254 * d * y + noise(1), side * t};
        const double from = std::sqrt(at.x * at.x + at.y * at.y),
                     turn = 0.4 * std::clamp((from - R) / (2 * d) + 1, 0.0, 1.0),
                     out = from > 0 ? std::sin(turn) / from : 0;
        if (from < R - 0.2 * d) rig.add(at, {out * at.x, out * at.y, side * std::cos(turn)});
      }
  for (int ring = 0; ring < 3; ring++)
    for (int k = 0; k < 130; k++) {
      const double a = 2 * pi * (k + 0.5 * ring) / 130, up = (ring - 1) * pi / 3.4;
      const Vec3d n{std::cos(up) * std::cos(a), std::cos(up) * std::sin(a), std::sin(up)};
      rig.add(R * Vec3d{std::cos(a), std::sin(a), 0} + t * n, n);
    }
  const double exact = 2 * t * pi * R * R + pi * pi * t * t * R + 4.0 / 3 * pi * t * t * t;
  const SurfaceComponent c = measured(rig);
  std::printf("film: by facets %+.1f %%, by normals %+.1f %%, open %.4f\n", 100 * (c.volume / exact - 1),
              100 * (byNormals(rig.surfels()) / exact - 1), c.open);
  EXPECT_NEAR(c.volume, exact, 0.03 * exact);
  EXPECT_GT(std::abs(byNormals(rig.surfels()) / exact - 1), 0.15);  // the case is sensitive to the measure
}

// From its rim, a hole of any width removes only the part above it, not a cone to the centre.
TEST(Facets, HoleOfABallRemovesOnlyItsCap) {
  const double angle = pi / 6, h = 1 - std::cos(angle), exact = 4.0 / 3 * pi - pi * h * h * (3 - h) / 3;
  SurfelRig rig(surfelScene(0.08));
  for (const SurfacePoint& p : test::spherePoints(2200, 1))
    if (p.normal.x < std::cos(angle)) rig.add(p.position, p.normal);
  const SurfaceComponent c = measured(rig);
  EXPECT_NEAR(c.volume, exact, 0.01 * exact);
  EXPECT_GT(c.open, 0.03);
}

/// Adds a disc of surfels at height z, up to `radius`.
void addDisc(SurfelRig& rig, double radius, double z, double up) {
  const double d = rig.world.surface.spacing;
  const auto n = static_cast<std::uint64_t>(pi * radius * radius / (0.85 * d * d));
  for (std::uint64_t k = 0; k < n; k++) {
    const auto noise = [&](std::uint64_t axis) {
      return 0.15 * d * (2 * randomUniform(5, Purpose::Test, rig.next, axis) - 1);
    };
    const double r = radius * std::sqrt((static_cast<double>(k) + 0.5) / static_cast<double>(n)),
                 a = 2.399963229728653 * static_cast<double>(k);
    rig.add({r * std::cos(a) + noise(0), r * std::sin(a) + noise(1), z}, {0, 0, up});
  }
}

// In very thin films the rim is a single ring of surfels, which is connected to neither side. There is a hole
// all along the rim. A measure from the middle of the film would miss half of its volume.
TEST(Facets, VolumeOfAFilmWithAnOpenRimIsExact) {
  const double d = 0.05, R = 12 * d;
  for (const double thick : {0.5, 0.8})
    for (const double tilt : {0.0, 0.7}) {
      const double h = thick * d, core = R - h,
                   exact = pi * core * core * h + 2 * pi * h * h * (core * pi / 4 + h / 3);
      SurfelRig rig(surfelScene(d));
      addDisc(rig, core, h, 1);
      addDisc(rig, R, 0, -1);
      const double round = core + h * std::sqrt(0.5);
      const int n = static_cast<int>(2 * pi * round / d);
      for (int k = 0; k < n; k++) {
        const Vec3d out{std::cos(2 * pi * k / n), std::sin(2 * pi * k / n), 0};
        rig.add(round * out + Vec3d{0, 0, h * std::sqrt(0.5)}, std::sqrt(0.5) * (out + Vec3d{0, 0, 1}));
      }
      const auto turned = [&](const Vec3d& x) {
        return Vec3d{std::cos(tilt) * x.x - std::sin(tilt) * x.z, x.y,
                     std::sin(tilt) * x.x + std::cos(tilt) * x.z};
      };
      for (std::size_t i = 0; i < rig.surfels().owned; i++)
        for (Vec3d* v : {&rig.surfels().position[i], &rig.surfels().normal[i], &rig.surfels().tangent[i]})
          *v = turned(*v);
      const SurfaceComponent c = measured(rig);
      std::printf("film of %g spacings, tilted by %g: %+.1f %%, open %.3f\n", thick, tilt,
                  100 * (c.volume / exact - 1), c.open);
      EXPECT_NEAR(c.volume, exact, 0.05 * exact);  // thirds of all axes: -48 and -49 %
    }
}

// Drops that meet a floor at a sharp angle: no surfel above is connected to one on the floor.
TEST(Facets, VolumesOfCapsOnAFloorAreExact) {
  const double d = 0.05, a = 12 * d;
  for (const double angle : {30.0, 45.0, 60.0, 90.0, 120.0}) {
    const double t = angle * pi / 180, R = a / std::sin(t), middle = -R * std::cos(t), h = R + middle,
                 exact = pi * h * h * (3 * R - h) / 3;
    SurfelRig rig(surfelScene(d));
    for (const SurfacePoint& p :
         test::spherePoints(static_cast<std::size_t>(4 * pi * R * R / (0.85 * d * d)), R))
      if (p.position.z + middle > 0) rig.add(p.position + Vec3d{0, 0, middle}, p.normal);
    addDisc(rig, a - 0.2 * d, 0, -1);
    // thirds: -3.5 % up to 60 degrees
    EXPECT_NEAR(measured(rig).volume, exact, 0.01 * exact) << angle << " degrees";
  }
}

// Edges gain the volume between the planes that meet there and the facets.
TEST(Facets, VolumeOfABoxIncludesItsEdges) {
  const double d = 0.1;
  SurfelRig rig(surfelScene(d));
  for (int a = 0; a < 3; a++)
    for (int side = -1; side <= 1; side += 2)
      for (int j = 0; j < 10; j++)
        for (int k = 0; k < 10; k++) {
          Vec3d x, n;
          x[a] = 0.5 * side, n[a] = side;
          x[(a + 1) % 3] = d * (j + 0.5) - 0.5, x[(a + 2) % 3] = d * (k + 0.5) - 0.5;
          rig.add(x, n);
        }
  EXPECT_NEAR(measured(rig).volume, 1, 0.01);
}

}  // namespace thaw
