// SPDX-License-Identifier: Apache-2.0
#include "core/surface/resampling/resample.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "core/simulation/views/views.hpp"
#include "tests/unit/core/surface/surfel_rig.hpp"

namespace thaw {
namespace {

using namespace test;

TEST(Resample, BlueNoiseBallIsUnchanged) {
  SurfelRig rig(surfelScene(0.1));
  for (const SurfacePoint& p : spherePoints(1450, 1)) rig.add(p.position, p.normal);
  const Resampled r = rig.resample(8);
  EXPECT_EQ(r.births + r.deaths, 0);
  EXPECT_TRUE(r.finished);
}

TEST(Resample, FillsABallFromOneCap) {
  SurfelRig rig(surfelScene(0.1));
  rig.world.clock.step = 7;
  for (const SurfacePoint& p : spherePoints(1450, 1))
    if (p.position.z > 0.5) rig.add(p.position, p.normal);
  const std::size_t before = rig.surfels().owned;
  Resampled r;
  const BirthPlace near = [&](const Surfels&, std::size_t, SurfacePoint& p, bool) {
    return std::abs(length(p.position) - 1) < 0.05;
  };
  for (int k = 0; k < 100 && !r.finished; k++) {
    rig.world.clock.step++;
    r = thaw::resample(surfaceView(rig.world), rig.ranks->halos(), rig.tools, 2, near);
    for (std::size_t i = 0; i < rig.surfels().owned; i++) {  // as the implicit force does
      Vec3d& n = rig.surfels().normal[i];
      n = rig.surfels().position[i] = normalized(rig.surfels().position[i]);
      rig.surfels().tangent[i] = anyTangent(n);
    }
  }
  EXPECT_TRUE(r.finished);
  const double hole = rig.largestHole(spherePoints(20000, 1));
  std::printf("cap: %zu surfels became %zu, largest hole %.3f\n", before, rig.surfels().owned, hole);
  EXPECT_LT(hole, 1.0);
  EXPECT_NEAR(static_cast<double>(rig.surfels().owned), 1450, 0.35 * 1450);
}

TEST(Resample, ClosesHolesOfABall) {
  SurfelRig rig(surfelScene(0.1));
  std::uint64_t draw = 0;
  for (const SurfacePoint& p : spherePoints(1450, 1))
    if (randomUniform(1, Purpose::Test, draw++) < 0.5) rig.add(p.position, p.normal);
  EXPECT_GT(rig.largestHole(spherePoints(20000, 1)), 1.2);
  const Resampled r = rig.resample(20);
  EXPECT_TRUE(r.finished);
  const double hole = rig.largestHole(spherePoints(20000, 1));
  std::printf("holes: %zu surfels, largest hole %.3f\n", rig.surfels().owned, hole);
  EXPECT_LT(hole, 1.0);
}

TEST(Resample, ThinsACrowdWithoutAHole) {
  SurfelRig rig(surfelScene(0.1));
  for (const SurfacePoint& p : spherePoints(20000, 1)) rig.add(p.position, p.normal);
  Resampled r = rig.resample(40);
  EXPECT_TRUE(r.finished);
  const double hole = rig.largestHole(spherePoints(20000, 1));
  std::printf("crowd: %lld births, %lld deaths, %zu surfels, largest hole %.3f\n",
              static_cast<long long>(r.births), static_cast<long long>(r.deaths), rig.surfels().owned, hole);
  EXPECT_LT(hole, 1.0);
  EXPECT_NEAR(static_cast<double>(rig.surfels().owned), 1450, 0.5 * 1450);
}

TEST(Resample, StretchingFourTimesAndBackLeavesNoHole) {
  SurfelRig rig(surfelScene(0.05));
  rig.world.scene.domain.min = {-5, -5, -5};
  const double small = 0.5;
  for (const SurfacePoint& p : spherePoints(1450, small)) rig.add(p.position, p.normal);
  double worst = 0, stretch = 1;
  const auto scaleTo = [&](double to) {
    Surfels& s = rig.surfels();
    for (std::size_t i = 0; i < s.owned; i++) {
      s.position[i].x *= to / stretch;
      s.normal[i] = normalized({s.normal[i].x / (to / stretch), s.normal[i].y, s.normal[i].z});
      s.tangent[i] = anyTangent(s.normal[i]);
    }
    stretch = to;
    rig.world.clock.step++;
    rig.resample(8);
    std::vector<SurfacePoint> truth;
    for (const SurfacePoint& p : spherePoints(6000, small))
      truth.push_back({{p.position.x * to, p.position.y, p.position.z},
                       normalized({p.normal.x / to, p.normal.y, p.normal.z})});
    worst = std::max(worst, rig.largestHole(truth));
  };
  for (int k = 1; k <= 12; k++) scaleTo(std::pow(4.0, k / 12.0));
  const std::size_t most = rig.surfels().owned;
  for (int k = 11; k >= 0; k--) scaleTo(std::pow(4.0, k / 12.0));
  std::printf("stretched: %zu surfels at four times, %zu back; largest hole %.3f\n", most,
              rig.surfels().owned, worst);
  EXPECT_LT(worst, 1.0);
  const double area = 4 * std::numbers::pi * small * small, law = area / (0.05 * 0.05 * std::sqrt(0.75));
  EXPECT_GT(static_cast<double>(rig.surfels().owned), 0.6 * law);
  EXPECT_LT(static_cast<double>(rig.surfels().owned), 1.5 * law);
}

TEST(Resample, BirthsOfACallAreCappedAndCounted) {  // stability row 18
  SurfelRig rig(surfelScene(0.05));
  for (int y = -3; y <= 3; y++)
    for (int x = -3; x <= 3; x++) rig.add({0.05 * x, 0.05 * y, 0}, {0, 0, 1});
  const auto before = static_cast<std::int64_t>(rig.surfels().owned), cap = birthCap(before);
  // room for 7,400
  const BirthPlace square = [](const Surfels&, std::size_t, SurfacePoint& p, bool) {
    return std::max(std::abs(p.position.x), std::abs(p.position.y)) < 2;
  };
  const auto call = [&] {
    rig.world.clock.step++;
    return thaw::resample(surfaceView(rig.world), rig.ranks->halos(), rig.tools, 200, square);
  };
  const Resampled first = call();
  std::printf("cap: %lld of at most %lld births in the first call\n", static_cast<long long>(first.births),
              static_cast<long long>(cap));
  EXPECT_TRUE(first.capped);
  EXPECT_FALSE(first.finished);
  EXPECT_LE(first.births, cap);
  EXPECT_GT(first.births, cap - cap / 20);
  EXPECT_EQ(rig.world.surface.counters.capped, 1);
  EXPECT_EQ(static_cast<std::int64_t>(rig.surfels().owned), before + first.births - first.deaths);
  // later calls continue where it ended
  Resampled last;
  for (int k = 0; k < 4 && !last.finished; k++) last = call();
  EXPECT_TRUE(last.finished);
  EXPECT_FALSE(last.capped);
  EXPECT_GT(rig.surfels().owned, 4500u);
}

TEST(Resample, EdgesRodsAndSheetsComeToRest) {
  for (const auto& [low, high] : {std::pair<Vec3d, Vec3d>{{0, 0, 0}, {1, 1, 1}},
                                  {{0, 0, 0}, {1, 1, 0.04}},
                                  {{0, 0, 0}, {2, 0.06, 0.06}},
                                  {{0, 0, 0}, {2, 0.15, 0.15}}}) {
    SurfelRig rig(surfelScene(0.1));
    Shape shape;
    shape.kind = ShapeKind::Mesh;
    shape.mesh = "box";
    TriangleMesh box = boxMesh(low, high);
    const std::vector<SurfaceSample> samples = sampleShape(
        shape, [&box](const std::string&) { return box; }, 0.1, 3);
    for (const SurfaceSample& s : samples) rig.add(s.position, s.normal);
    const Resampled first = rig.resample(20);
    EXPECT_TRUE(first.finished);
    rig.world.clock.step++;
    const Resampled second = rig.resample(20);
    const auto changes = second.births + second.deaths;
    double out = 0;
    for (std::size_t i = 0; i < rig.surfels().owned; i++)
      for (int k = 0; k < 3; k++)
        out = std::max({out, low[k] - rig.surfels().position[i][k], rig.surfels().position[i][k] - high[k]});
    std::printf("box %.2f: %zu samples, %lld births, %lld deaths, then %lld; out of it by %.3f spacings\n",
                high.z, samples.size(), static_cast<long long>(first.births),
                static_cast<long long>(first.deaths), static_cast<long long>(changes), out / 0.1);
    EXPECT_EQ(changes, 0);
    // bodies thinner than the spacing have edges everywhere
    EXPECT_LT(out, std::min(high.z - low.z, high.y - low.y) < 0.1 ? 0.05 : 0.012);
  }
}

TEST(Resample, DensityFollowsCurvature) {
  // The target is half a radian between surfels, 0.5 R, if that is less than the spacing of 0.08. It is 0.05
  // on a ball of 0.1, and the spacing on one of 0.4.
  for (const double adapt : {0.0, 0.4})
    for (const double R : {0.1, 0.4}) {
      Scene scene = surfelScene(0.08);
      scene.surface.adapt = adapt;
      SurfelRig rig(scene);
      Surfels& s = rig.surfels();
      for (const SurfacePoint& p :
           spherePoints(static_cast<std::size_t>(4 * std::numbers::pi * R * R / (0.87 * 0.08 * 0.08)), R))
        rig.add(p.position, p.normal);
      for (int k = 0; k < 12; k++) {
        rig.world.clock.step++;
        rig.resample(10);
        for (std::size_t i = 0; i < s.owned; i++) {
          s.normal[i] = normalized(s.position[i]);
          s.position[i] = R * s.normal[i];
          s.tangent[i] = anyTangent(s.normal[i]);
        }
      }
      double radius = 0;
      for (std::size_t i = 0; i < s.owned; i++) radius += s.radius[i] / 0.08 / static_cast<double>(s.owned);
      const double wanted = adapt > 0 ? std::min(1.0, 0.5 * R / 0.08) : 1,
                   area = 4 * std::numbers::pi * R * R;
      const double hole = rig.largestHole(spherePoints(4000, R)),
                   each = area / static_cast<double>(s.owned) / (0.08 * 0.08);
      std::printf(
          "adapt %.1f, R %.1f: %zu surfels, mean radius %.3f (wanted %.3f), area per surfel %.3f, largest "
          "hole "
          "%.3f spacings\n",
          adapt, R, s.owned, radius, wanted, each, hole);
      EXPECT_NEAR(radius, wanted, 0.11 * wanted);
      EXPECT_LT(hole, 1.1 * wanted);
      EXPECT_LT(each, 1.2 * wanted * wanted);
      if (wanted == 1) { EXPECT_GT(each, 0.5); }
    }
}

TEST(Resample, SeparateTableOfFewOpenSurfelsGivesTheSameBits) {
  std::vector<std::byte> state[2];
  std::int64_t births[2];
  for (const bool apart : {false, true}) {
    SurfelRig rig(surfelScene(0.05));
    for (const SurfacePoint& p : spherePoints(5800, 1))
      // a slot, which closes from its rims
      if (std::abs(p.position.x) > 0.2 || p.position.z < 0) rig.add(p.position, p.normal);
    rig.tools.activeSet.few = apart ? 12 : 0;
    const BirthPlace near = [](const Surfels&, std::size_t, SurfacePoint& p, bool) {
      p.position = normalized(p.position), p.normal = p.position;
      return true;
    };
    std::fill_n(rig.surfels().resampleMargin.data(), rig.surfels().owned, 0.0f);
    births[apart] = thaw::resample(surfaceView(rig.world), rig.ranks->halos(), rig.tools, 30, near).births;
    EXPECT_EQ(rig.tools.activeSet.rows.empty(), !apart);  // the separate table was used
    EXPECT_FALSE(rig.tools.activeSet.taken);
    const Surfels& s = rig.surfels();
    const std::size_t bytes = s.stateBytes();
    state[apart].resize(s.owned * bytes);
    for (std::size_t i = 0; i < s.owned; i++) s.packState(i, &state[apart][i * bytes]);
  }
  EXPECT_GT(births[0], 300);
  EXPECT_EQ(births[0], births[1]);
  EXPECT_TRUE(state[0] == state[1]);
}

}  // namespace
}  // namespace thaw
