// SPDX-License-Identifier: Apache-2.0
#include "core/surface/topology/merge.hpp"

#include "core/math/hash_random.hpp"
#include "core/surface/search/near_sheets.hpp"
#include "core/surface/seeding/grow.hpp"
#include "tests/support/surface/relax_rig.hpp"
#include "tests/support/surface/surface_rig.hpp"
#include "tests/support/surface/surface_world.hpp"

using namespace thaw;
using namespace thaw::test;

namespace {

/// Two balls of radius 0.5 whose surfaces overlap by `overlap` (m) along x.
void twoBalls(SurfaceRig& rig, double overlap) {
  rig.ball({-0.5, 0, 0}, 0.5, 1);
  rig.ball({0.5 - overlap, 0.02, 0.01}, 0.5, 1 + rig.particles);
}

}  // namespace

TEST(Merge, BallsJoinOnlyWhenAParticleIsInside) {
  SerialSurfaceRig apart;
  twoBalls(apart, -0.02);
  apart.update();
  EXPECT_EQ(apart.components().size(), 2u);
  EXPECT_EQ(apart.world.surface.counters.merges, 0);
  EXPECT_EQ(apart.world.surface.counters.deaths, 0);

  SerialSurfaceRig met;
  twoBalls(met, 0.15);
  const auto surfels = static_cast<std::int64_t>(met.surfels);
  met.world.clock.step = 3;
  met.update();
  ASSERT_EQ(met.components().size(), 1u);
  EXPECT_EQ(met.components()[0].label, 1u);
  EXPECT_EQ(met.world.surface.counters.merges, 1);
  ASSERT_EQ(met.world.surface.events.size(), 1u);
  EXPECT_EQ(met.world.surface.events[0].kind, SurfaceEventKind::Merge);
  EXPECT_EQ(met.world.surface.events[0].label, 1u);
  EXPECT_GT(met.world.surface.counters.deaths, 0);
  EXPECT_EQ(met.components()[0].surfels + met.world.surface.counters.deaths, surfels);
  // no surfel of one ball is left inside the other
  for (std::size_t i = 0; i < met.f().owned; i++) {
    const Vec3d x = met.f().position[i];
    EXPECT_GT(std::max(length(x - Vec3d{-0.5, 0, 0}), length(x - Vec3d{0.35, 0.02, 0.01})), 0.5 - 1e-9);
    EXPECT_GT(std::min(length(x - Vec3d{-0.5, 0, 0}), length(x - Vec3d{0.35, 0.02, 0.01})), 0.495);
  }
}

TEST(Merge, LiquidsThatTouchJoinAndDoNotFlicker) {
  // Two balls approach and separate in steps of a tenth of a spacing, with noise: one merge and one split,
  // wherever they turn.
  for (const double turn : {0.5}) {
    Scene s;
    s.spacing = 0.1;
    s.domain.min = {-2, -1, -1};
    s.domain.max = {2, 1, 1};
    s.domain.gravity = {};
    s.materials.emplace_back();
    s.materials[0].name = "oil";
    s.surface.on = true;
    for (const double x : {-0.3, 0.48}) {
      s.bodies.emplace_back();
      s.bodies.back().shape.kind = ShapeKind::Sphere;
      s.bodies.back().shape.radius = 0.3;
      s.bodies.back().shape.move = {x, 0, 0};
    }
    SurfaceWorld balls(s);
    ASSERT_EQ(balls.components().size(), 2u);
    const auto gap = [&] {  // distance of the particles, in spacings
      double low = 1e300, high = -1e300;
      for (std::size_t i = 0; i < balls.w.particles.owned; i++) {
        const double x = balls.place(i).x;
        if (balls.w.particles.body[i] == 0) high = std::max(high, x);
        else low = std::min(low, x);
      }
      return (low - high) / s.spacing;
    };
    const auto move = [&](double by) {
      for (std::size_t i = 0; i < balls.w.particles.owned; i++)
        if (balls.w.particles.body[i] == 1) balls.place(i).x += by * s.spacing;
      balls.update();
    };
    double joined = 0, parted = 0;
    while (gap() > turn + 0.05) {
      move(-0.1);
      if (balls.components().size() == 1 && joined == 0) joined = gap();
    }
    for (int k = 0; k < 6; k++) move(k % 2 ? 0.08 : -0.08);
    while (gap() < 4.5) {
      move(0.1);
      if (balls.components().size() == 2 && parted == 0) {
        parted = gap();
        for (int k = 0; k < 6; k++) move(k % 2 ? 0.08 : -0.08);
      }
    }
    const SurfaceCounters& c = balls.w.surface.counters;
    std::printf("turned at %.1f spacings: joined at %.2f, parted at %.2f; %lld merges, %lld splits\n", turn,
                joined, parted, static_cast<long long>(c.merges), static_cast<long long>(c.splits));
    EXPECT_EQ(c.merges, 1);
    EXPECT_EQ(c.splits, 1);
    EXPECT_NEAR(joined, 0.95, 0.1);
    EXPECT_GT(parted, 1.45);
  }
}

TEST(Merge, SceneRulesDecideMerges) {
  for (const bool liquid : {false, true})
    for (const MergeRule rule : {MergeRule::Liquid, MergeRule::All, MergeRule::None}) {
      SerialSurfaceRig rig;
      rig.world.scene.surface.merge = rule;
      rig.liquid = liquid;
      twoBalls(rig, 0.15);
      rig.update();
      const bool joins = rule == MergeRule::All || (rule == MergeRule::Liquid && liquid);
      EXPECT_EQ(rig.components().size(), joins ? 1u : 2u);
      EXPECT_EQ(rig.world.surface.counters.merges, joins ? 1 : 0);
      if (joins) continue;
      // kept apart: surfels inside the other ball have moved back halfway
      EXPECT_EQ(rig.world.surface.counters.deaths, 0);
      double deepest = 0;
      for (std::size_t i = 0; i < rig.f().owned; i++) {
        const Vec3d other = rig.f().component[i] == 1 ? Vec3d{0.35, 0.02, 0.01} : Vec3d{-0.5, 0, 0};
        deepest = std::max(deepest, 0.5 - length(rig.f().position[i] - other));
      }
      EXPECT_LT(deepest, 0.09);
    }
}

TEST(Merge, DropMergesIntoAPool) {
  SerialSurfaceRig rig;
  rig.box({-1, -1, -1}, {20, 20, 10}, 1);
  rig.ball({0.01, 0.02, 0.1}, 0.3, 1 + rig.particles);
  rig.particle({0, 0, 1.5}, 1 + rig.particles);  // another drop, far away and without a surface
  rig.update();
  ASSERT_EQ(rig.components().size(), 2u);
  EXPECT_EQ(rig.world.surface.counters.merges, 1);
  EXPECT_EQ(rig.components()[1].particles, 1);
  for (std::size_t i = 0; i < rig.f().owned; i++) {
    const Vec3d x = rig.f().position[i];
    const bool insideBall = length(x - Vec3d{0.01, 0.02, 0.1}) < 0.29,
               insidePool = x.z < -0.01 && x.z > -0.99 && std::abs(x.x) < 0.99 && std::abs(x.y) < 0.99;
    EXPECT_FALSE(insideBall || insidePool) << x.x << " " << x.y << " " << x.z;
  }
}

TEST(Inside, IsExactForACubeAndAThinSheet) {
  for (const int layers : {10, 1}) {
    SerialSurfaceRig rig;
    const double z = 0.1 * layers;
    rig.box({-0.5, -0.5, 0}, {10, 10, layers}, 1);
    Bins bins;
    fillBins(rig.f().position.data(), rig.f().owned, rig.world.surface.surfelSupport, bins);
    InsideTools tools;
    std::vector<SurfaceSide> sides;
    int wrong = 0, asked = 0;
    for (int k = 0; k < 20000; k++) {
      const auto u = [&](std::uint64_t s) {
        return randomUniform(s, Purpose::Test, static_cast<std::uint64_t>(k));
      };
      const Vec3d x{-0.7 + 1.4 * u(1), -0.7 + 1.4 * u(2), -0.2 + (z + 0.4) * u(3)};
      const double depth = std::min({0.5 - std::abs(x.x), 0.5 - std::abs(x.y), x.z, z - x.z});
      if (std::abs(depth) < 0.1 * rig.d) continue;
      findSides(rig.f(), bins, {x, noComponent, true, rig.world.surface.particleSupport}, tools, sides);
      if (sides.empty()) continue;
      asked++;
      if ((sides[0].distance < 0) != (depth > 0))
        wrong++, std::printf("%g %g %g: %g\n", x.x, x.y, x.z, sides[0].distance);
    }
    std::printf("%d layers: %d of %d wrong\n", layers, wrong, asked);
    EXPECT_EQ(wrong, 0);
  }
}

TEST(NearSheets, FindsGapSheetAndFold) {
  const Vec3d up{0, 0, 1}, down{0, 0, -1}, side{1, 0, 0};
  EXPECT_EQ(facing({0.1, 0, 0.3}, up, down), Facing::AcrossGap);
  EXPECT_EQ(facing({0.1, 0, -0.3}, up, down), Facing::AcrossSheet);
  EXPECT_EQ(facing({0.1, 0, 0}, up, up), Facing::Same);
  EXPECT_EQ(facing({0.1, 0, -0.1}, up, side), Facing::Same);
}

namespace {

/// Two fingers of one component, four layers thick, with surfels half a spacing above the particles, so that
/// their surfaces are `gap` spacings apart. Returns the mean height of relaxed surfels above the outermost
/// particles in spacings, in the gap and outside.
struct Fingers {
  double inside = 0, outside = 0;
  std::size_t surfelsInside = 0;
};
Fingers fingersApart(double gap) {
  RelaxRig rig(0.5, 24);
  for (int x = -9; x <= 9; x++)
    for (int y = -9; y <= 9; y++)
      for (int z = 0; z < 4; z++)
        for (const int side : {-1, 1}) rig.addParticle({double(x), double(y), side * (0.5 * gap + 0.5 + z)});
  for (int x = -18; x <= 18; x++)
    for (int y = -18; y <= 18; y++)
      for (const int side : {-1, 1}) {
        rig.addSurfel({0.5 * x, 0.5 * y, side * 0.5 * gap}, {0, 0, double(-side)});
        rig.addSurfel({0.5 * x, 0.5 * y, side * (0.5 * gap + 4)}, {0, 0, double(side)});
      }
  rig.place();
  rig.relaxSurfels(40);
  const Surfels& s = rig.w.surface.surfels;
  Fingers f;
  double outer = 0;
  for (std::size_t i = 0; i < s.owned; i++) {
    const Vec3d x = s.position[i];
    if (std::abs(x.y) > 5 || std::abs(x.x - 1) > 4 || std::abs(s.normal[i].z) < 0.7) continue;
    const bool in = x.z * s.normal[i].z < 0;
    if (in) f.inside += 0.5 * gap + 0.5 - std::abs(x.z), f.surfelsInside++;
    else f.outside += std::abs(x.z) - (0.5 * gap + 3.5), outer++;
  }
  f.inside /= std::max<double>(1, static_cast<double>(f.surfelsInside));
  f.outside /= std::max(1.0, outer);
  return f;
}

}  // namespace

TEST(NearSheets, FingersOfOneBodyDoNotMerge) {
  for (const double gap : {3.0, 2.0, 1.0, 0.5}) {
    const Fingers f = fingersApart(gap);
    std::printf("gap %.1f: %zu surfels in it, %.3f spacings above the particles, outside %.3f\n", gap,
                f.surfelsInside, f.inside, f.outside);
    EXPECT_GT(f.surfelsInside, 500u);
    EXPECT_NEAR(f.inside, f.outside, gap > 2 ? 0.05 : 0.2);
  }
}
