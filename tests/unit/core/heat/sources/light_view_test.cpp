// SPDX-License-Identifier: Apache-2.0
// Profiles of lamps and lasers, and the rays near a point.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/heat/sources/light_sources.hpp"
#include "core/heat/sources/light_view.hpp"
#include "core/scene/source_times.hpp"

namespace thaw {
namespace {

LightSource sourceOf(LightProfile profile) {
  LightSource s;
  s.profile = profile;
  s.power = 1;
  s.radius = 0.1;
  s.position = {0.1, 0.2, 0.3};
  s.direction = normalized(Vec3d{0.3, -0.2, -1});
  return s;
}

std::vector<LightView> viewsOf(const LightSource& s, const Bounds& bodies, double spacing) {
  std::vector<LightView> views;
  addViews(s, 0, bodies, spacing, views);
  return views;
}

double powerOf(const LightSource& s, const std::vector<LightView>& views) {
  double sum = 0;
  for (const LightView& v : views)
    for (std::int64_t j = 0; j < v.count[1]; j++)
      for (std::int64_t i = 0; i < v.count[0]; i++) sum += powerOfCell(s, v, v.low[0] + i, v.low[1] + j);
  return sum;
}

constexpr Bounds around{{-1, -1, -1}, {1, 1, 1}};

}  // namespace

TEST(LightView, CellsOfABeamHaveItsWholePower) {
  const LightSource s = sourceOf(LightProfile::Gaussian);
  EXPECT_NEAR(powerOf(s, viewsOf(s, around, 0.05)), 1, 1e-8);
  EXPECT_NEAR(powerOf(s, viewsOf(s, around, 0.5)), 1, 1e-8);
}

TEST(LightView, FacesAroundAPointShareItsPower) {
  for (const LightProfile profile : {LightProfile::Isotropic, LightProfile::Cosine}) {
    const LightSource s = sourceOf(profile);
    EXPECT_NEAR(powerOf(s, viewsOf(s, around, 0.05)), 1, 1e-9);
  }
}

TEST(LightView, PowerOfACellIsItsSolidAngle) {
  const LightSource s = sourceOf(LightProfile::Isotropic);
  for (const LightView& v : viewsOf(s, around, 0.05)) {
    const double x = (static_cast<double>(v.low[0]) + 3.5) * v.cell,
                 y = (static_cast<double>(v.low[1]) + 5.5) * v.cell;
    const double angle = v.cell * v.cell / std::pow(1 + x * x + y * y, 1.5);
    EXPECT_NEAR(powerOfCell(s, v, v.low[0] + 3, v.low[1] + 5) / (angle / (4 * std::numbers::pi)), 1, 1e-3);
  }
}

TEST(LightView, PowerOfACellFollowsLambertsLaw) {
  const LightSource s = sourceOf(LightProfile::Cosine);
  for (const LightView& v : viewsOf(s, around, 0.05)) {
    const std::int64_t i = v.low[0] + 3, j = v.low[1] + v.count[1] - 4;
    const LightRay ray = rayOf(v, i, j);
    const double along = dot(ray.direction, v.ahead), angle = v.cell * v.cell * along * along * along;
    const double cosine = std::max(0.0, dot(ray.direction, s.direction));
    EXPECT_NEAR(powerOfCell(s, v, i, j), cosine * angle / std::numbers::pi, 1e-3 * angle);
  }
}

TEST(LightView, RaysNearAPointAreThoseOfABruteForceSearch) {
  for (const LightProfile profile : {LightProfile::Uniform, LightProfile::Isotropic}) {
    const LightSource s = sourceOf(profile);
    for (const LightView& v : viewsOf(s, around, 0.2)) {
      for (const Vec3d& x : {Vec3d{0.5, 0.4, -0.3}, Vec3d{0.15, 0.2, 0.1}, Vec3d{-0.9, 0.8, 0.9}}) {
        for (const double reach : {0.15, 0.3}) {
          std::vector<double> found(v.cells(), -1), expected(v.cells(), -1);
          eachRayNear(v, sightOf(v, x), reach, [&](std::size_t c, double d2) { found[c] = std::sqrt(d2); });
          for (std::size_t c = 0; c < v.cells(); c++) {
            const auto cell = static_cast<std::int64_t>(c);
            const LightRay ray = rayOf(v, v.low[0] + cell % v.count[0], v.low[1] + cell / v.count[0]);
            const double along = dot(x - ray.start, ray.direction);
            const double d = length(x - ray.start - ray.direction * along);
            if (d < reach && (v.parallel || along > 0)) expected[c] = d;
          }
          for (std::size_t c = 0; c < v.cells(); c++) EXPECT_NEAR(found[c], expected[c], 1e-6);
        }
      }
    }
  }
}

TEST(SourceTimes, AStepCountsByTheFractionInWhichASourceIsOn) {
  EXPECT_EQ(shareOn(1, 2, 0, 1), 0);
  EXPECT_EQ(shareOn(1, 2, 0.5, 1.5), 0.5);
  EXPECT_EQ(shareOn(1, 2, 0.5, 2.5), 0.5);
  EXPECT_EQ(shareOn(1, 2, 1.2, 1.4), 1);
  EXPECT_EQ(shareOn(1, 2, 1, 1), 1);
  EXPECT_EQ(shareOn(1, 2, 2, 2), 0);
}

TEST(LightSources, PointsOfAnAreaLampHaveItsCentreAndSize) {
  Scene scene;
  Lamp lamp;
  lamp.kind = LampKind::Area;
  lamp.power = 8;
  lamp.width = 0.4;
  lamp.depth = 0.8;
  lamp.position = {1, 2, 3};
  scene.lamps = {lamp};
  Vec3d mean{}, square{};
  for (int step = 0; step < 16; step++) {
    const std::vector<LightSource> list = lightSources(scene, 0, 1, step);
    ASSERT_EQ(list.size(), 1u);
    EXPECT_EQ(list[0].power, 8);
    const Vec3d d = list[0].position - lamp.position;
    mean += d;
    square += Vec3d{d.x * d.x, d.y * d.y, d.z * d.z} / 16.0;
  }
  EXPECT_NEAR(length(mean), 0, 1e-14);
  EXPECT_NEAR(square.x, 0.4 * 0.4 * 5 / 64, 1e-14);  // four points: 15/16 of a line's 1/12
  EXPECT_NEAR(square.y, 0.8 * 0.8 * 5 / 64, 1e-14);
}

}  // namespace thaw
