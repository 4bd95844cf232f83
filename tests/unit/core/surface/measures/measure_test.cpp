// SPDX-License-Identifier: Apache-2.0
#include "core/surface/measures/measure.hpp"

#include <numbers>

#include "core/surface/relaxation/enforce_volume.hpp"
#include "tests/support/surface/surface_rig.hpp"

using namespace thaw;
using namespace thaw::test;

TEST(Measure, AreaAndVolumeOfABallAreExact) {
  for (const double R : {0.2, 0.4, 0.8, 1.6}) {  // 2, 4, 8, 16 spacings
    SerialSurfaceRig rig;
    rig.world.scene.surface.enforceVolume = 0;
    rig.ball({0.013, -0.2, 0.1}, R);
    rig.update();
    ASSERT_EQ(rig.components().size(), 1u);
    const SurfaceComponent& c = rig.components()[0];
    const double area = c.area / (4 * std::numbers::pi * R * R) - 1,
                 volume = c.volume / (4.0 / 3 * std::numbers::pi * R * R * R) - 1;
    std::printf("R/dx = %g: area %+.2e, volume %+.2e\n", R / rig.dx, area, volume);
    EXPECT_LT(std::abs(area), 0.01);
    EXPECT_LT(std::abs(volume), 0.01);
    EXPECT_NEAR(c.mass, 1000 * c.particleVolume, 1e-9 * c.mass);
  }
}

TEST(Measure, BallAcrossAPeriodicSideIsInOnePiece) {
  double volume[2], area[2];
  for (int shifted = 0; shifted < 2; shifted++) {
    SurfaceRig rig;
    rig.world.scene.domain.side[0] = {Side::Periodic, Side::Periodic};
    prepareSurface(rig.world);
    SerialSurfaceRanks halos(rig.world.surface.grid);
    rig.ball({shifted ? 1.95 : 0.0, 0, 0}, 0.8);
    rig.update(halos.halos());
    ASSERT_EQ(rig.components().size(), 1u);
    volume[shifted] = rig.components()[0].volume;
    area[shifted] = rig.components()[0].area;
  }
  EXPECT_NEAR(volume[1], volume[0], 1e-9);
  EXPECT_NEAR(area[1], area[0], 1e-9);
}

namespace {

/// A box along x from `low` in a domain of 4 m, measured with periodic sides along x.
SurfaceComponent measuredBox(double low, int cells) {
  SurfaceRig rig;
  rig.world.scene.surface.enforceVolume = 0;
  rig.world.scene.domain.side[0] = {Side::Periodic, Side::Periodic};
  prepareSurface(rig.world);
  SerialSurfaceRanks halos(rig.world.surface.grid);
  rig.box({low, 0.3, -0.2}, {cells, 4, 6});
  const auto wrap = [](Vec3d& x) { x.x -= 4 * std::floor((x.x + 2) / 4); };
  for (std::size_t i = 0; i < rig.p().owned; i++) wrap(rig.p().position[i]);
  for (std::size_t i = 0; i < rig.f().owned; i++) wrap(rig.f().position[i]);
  rig.update(halos.halos());
  EXPECT_EQ(rig.components().size(), 1u);
  return rig.components()[0];
}

}  // namespace

// A body is longer than half the domain, so its far end is nearer to the particle that names it across the
// side. It must not be assigned to the image there.
TEST(Measure, LongBodyAcrossAPeriodicSideIsInOnePiece) {
  const SurfaceComponent whole = measuredBox(-1.5, 28);
  EXPECT_NEAR(whole.centroid.x, -0.1, 1e-9);
  for (const double low : {-0.3, 0.9, 1.7}) {
    const SurfaceComponent c = measuredBox(low, 28);
    const double middle = low + 1.4 - (low + 1.4 >= 2 ? 4 : 0);
    EXPECT_NEAR(c.centroid.x, middle, 1e-9) << low;
    EXPECT_NEAR(c.centroid.y, 0.5, 1e-9);
    EXPECT_NEAR(c.centroid.z, 0.1, 1e-9);
    EXPECT_NEAR(c.volume, whole.volume, 1e-9);
  }
}

TEST(Measure, SpanningComponentHasItsCentroidInTheMiddleAndItsVolume) {
  SurfaceRig rig;
  rig.world.scene.surface.enforceVolume = 0;
  for (int a = 0; a < 2; a++)
    rig.world.scene.domain.side[static_cast<std::size_t>(a)] = {Side::Periodic, Side::Periodic};
  prepareSurface(rig.world);
  SerialSurfaceRanks halos(rig.world.surface.grid);
  for (int y = 0; y < 40; y++)
    for (int x = 0; x < 40; x++)
      for (int z = 0; z < 4; z++) rig.particle({-2 + 0.1 * (x + 0.5), -2 + 0.1 * (y + 0.5), 0.1 * (z + 0.5)});
  for (int y = 0; y < 80; y++)
    for (int x = 0; x < 80; x++)
      for (const int up : {0, 1})
        rig.surfel({-2 + 0.05 * (x + 0.5), -2 + 0.05 * (y + 0.5), 0.4 * up}, {0, 0, up ? 1.0 : -1.0});
  rig.update(halos.halos());
  ASSERT_EQ(rig.components().size(), 1u);
  const SurfaceComponent& c = rig.components()[0];
  EXPECT_NEAR(c.centroid.x, 0, 1e-9);
  EXPECT_NEAR(c.centroid.y, 0, 1e-9);
  EXPECT_NEAR(c.centroid.z, 0.2, 1e-9);
  EXPECT_NEAR(c.volume / 6.4 - 1, 0, 1e-6);
}

TEST(EnforceVolume, RestoresABallAndAFlattenedBall) {
  for (const double flat : {1.0, 0.5}) {
    const double wide = 1 / std::sqrt(flat);
    SerialSurfaceRig rig;
    rig.ball({0, 0, 0}, 0.8);
    for (std::size_t i = 0; i < rig.p().owned; i++)
      rig.p().position[i] = {wide * rig.p().position[i].x, wide * rig.p().position[i].y,
                             flat * rig.p().position[i].z};
    for (std::size_t i = 0; i < rig.f().owned; i++) {  // shrunk by 5 %
      Vec3d &x = rig.f().position[i], &n = rig.f().normal[i];
      x = 0.95 * Vec3d{wide * x.x, wide * x.y, flat * x.z};
      n = normalized({n.x / wide, n.y / wide, n.z / flat});
      rig.f().tangent[i] = normalized(rig.f().tangent[i] - dot(rig.f().tangent[i], n) * n);
    }
    rig.world.scene.surface.enforceVolume = 0;
    rig.update();
    const double before = rig.components()[0].volume / rig.components()[0].particleVolume - 1;
    rig.world.scene.surface.enforceVolume = 1;
    rig.update();
    const double after = rig.components()[0].volume / rig.components()[0].particleVolume - 1;
    std::printf("flattened to %g: volume %+.2f %% before, %+.3f %% after\n", flat, 100 * before, 100 * after);
    EXPECT_LT(before, -0.1);
    EXPECT_LT(std::abs(after), 0.01);
  }
}

// A flat drop responds to an offset with twice its area. The next offset accounts for that.
TEST(EnforceVolume, OffsetsFollowTheResponseOfTheVolume) {
  SerialSurfaceRig rig;
  Surface& s = rig.world.surface;
  s.spacing = 1;
  s.components.resize(1);
  SurfaceComponent& c = s.components[0];
  c.label = 1, c.particles = 10, c.surfels = 100, c.area = c.liquidArea = 1, c.targetVolume = 1,
  c.volume = 0.9;
  std::vector<VolumeMove> moves;
  offsetToVolume(s, {}, 1, 1, false, moves);
  EXPECT_NEAR(c.isoOffset, 0.1, 1e-12);
  c.volume = 1.1;
  offsetToVolume(s, {}, 1, 1, false, moves);
  EXPECT_NEAR(c.isoOffset, 0.05, 1e-12);
}

// Beyond the range of the iteration level the surface is offset directly.
TEST(EnforceVolume, OffsetsBeyondTheRangeOfTheLevel) {
  for (const double swollen : {1.2, 0.85}) {  // particles that have expanded or contracted
    const double end = swollen > 1 ? -mostInwardOffset : mostOutwardOffset;
    SerialSurfaceRig rig;
    rig.ball({0, 0, 0}, 0.8);
    for (std::size_t i = 0; i < rig.p().owned; i++) rig.p().position[i] = swollen * rig.p().position[i];
    for (std::size_t i = 0; i < rig.f().owned; i++) rig.f().position[i] = swollen * rig.f().position[i];
    rig.update();
    for (int k = 0; k < 2; k++) {
      rig.world.surface.components[0].isoOffset = end * rig.dx;
      rig.update();
      const SurfaceComponent& c = rig.components()[0];
      EXPECT_NEAR(c.volume / c.particleVolume, 1, 2e-3) << swollen;
      EXPECT_NEAR(c.isoOffset, end * rig.dx, 0.1 * rig.dx);  // it needs at least this
    }
  }
}

TEST(EnforceVolume, AppliesToFrozenSurfacesButNotToUnmeltedOrDetailedOnes) {
  for (const int way : {0, 1, 2}) {  // frozen, never liquid, frozen under a mesh's detail
    SerialSurfaceRig rig;
    rig.liquid = false;
    rig.ball({0, 0, 0}, 0.8);
    rig.update();
    for (std::size_t i = 0; i < rig.f().owned; i++)
      rig.f().position[i] = 0.95 * rig.f().position[i], rig.f().detail[i] = way == 2;
    ASSERT_EQ(rig.components().size(), 1u);
    if (way != 1) rig.world.surface.components[0].isoOffset = 1e-3 * rig.dx;
    rig.update();
    const double off = rig.components()[0].volume / rig.components()[0].particleVolume - 1;
    if (way == 0) EXPECT_LT(std::abs(off), 0.006);
    else EXPECT_LT(off, -0.1);
  }
}
