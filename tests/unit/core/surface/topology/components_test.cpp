// SPDX-License-Identifier: Apache-2.0
#include "core/surface/topology/components.hpp"

#include <chrono>

#include "core/math/hash_random.hpp"
#include "tests/support/surface/surface_rig.hpp"

using namespace thaw;
using namespace thaw::test;

TEST(Components, ACubeIsOneBody) {  // stability row 19: S_rest alone finds six
  SerialSurfaceRig rig;
  rig.box({-0.5, -0.5, -0.5}, {10, 10, 10});
  rig.update();
  ASSERT_EQ(rig.components().size(), 1u);
  EXPECT_EQ(rig.components()[0].label, 1u);
  EXPECT_EQ(rig.components()[0].particles, 1000);
  EXPECT_EQ(rig.components()[0].surfels, 2400);
  EXPECT_EQ(rig.world.surface.counters.splits, 0);
  EXPECT_NEAR(rig.components()[0].area, 6, 0.001);
  EXPECT_NEAR(rig.components()[0].volume, 1, 0.001);
}

TEST(Components, TouchingBodiesAreSeparateAtTheStart) {
  SerialSurfaceRig rig;
  rig.world.scene.surface.merge = MergeRule::None;
  rig.box({-1, -0.3, -0.3}, {10, 6, 6});
  rig.body = 1;
  rig.box({0, -0.3, -0.3}, {10, 6, 6});
  rig.update();
  ASSERT_EQ(rig.components().size(), 2u);
  EXPECT_EQ(rig.components()[0].particles, 360);
  EXPECT_EQ(rig.components()[1].label, 361u);
  EXPECT_EQ(rig.components()[1].particles, 360);
  EXPECT_EQ(rig.components()[0].surfels, rig.components()[1].surfels);
}

TEST(Components, ADumbbellPulledApartSplitsOnce) {
  SerialSurfaceRig rig;
  rig.ball({-0.6, 0, 0}, 0.5);
  const std::uint64_t second = rig.particles;
  rig.ball({0.6, 0, 0}, 0.5);
  rig.box({-0.15, -0.1, -0.1}, {3, 2, 2});  // the neck
  rig.update();
  ASSERT_EQ(rig.components().size(), 1u);
  const std::int64_t surfels = rig.components()[0].surfels;
  for (std::size_t i = 0; i < rig.p().owned; i++)
    rig.p().position[i].x += rig.p().position[i].x > 0 ? 0.3 : 0;
  for (std::size_t i = 0; i < rig.f().owned; i++)
    rig.f().position[i].x += rig.f().position[i].x > 0 ? 0.3 : 0;
  rig.world.clock.step = 7;
  rig.update();
  ASSERT_EQ(rig.components().size(), 2u);
  EXPECT_EQ(rig.components()[0].label, 1u);
  EXPECT_EQ(rig.components()[1].label, 1 + second);
  EXPECT_EQ(rig.components()[0].surfels + rig.components()[1].surfels, surfels);
  ASSERT_EQ(rig.world.surface.events.size(), 1u);
  const SurfaceEvent& e = rig.world.surface.events[0];
  EXPECT_EQ(e.step, 7);
  EXPECT_EQ(e.kind, SurfaceEventKind::Split);
  EXPECT_EQ(e.label, 1u);
  EXPECT_EQ(e.other, 1 + second);
  EXPECT_EQ(rig.world.surface.counters.splits, 1);
  EXPECT_EQ(rig.world.surface.counters.lost, 0);
}

TEST(Components, LabelChangesAreLogged) {
  SerialSurfaceRig rig;
  rig.ball({0, 0, 0}, 0.5);
  rig.update();
  rig.update();
  ASSERT_EQ(rig.world.surface.events.size(), 0u);
  std::vector<std::uint32_t> stay;  // all but the particle that labels the component
  for (std::uint32_t i = 0; i < rig.p().owned; i++)
    if (rig.p().id[i] != 0) stay.push_back(i);
  rig.p().reorder(stay);
  rig.world.clock.step = 9;
  rig.update();
  ASSERT_EQ(rig.world.surface.events.size(), 1u);
  const SurfaceEvent& e = rig.world.surface.events[0];
  EXPECT_EQ(e.step, 9);
  EXPECT_EQ(e.kind, SurfaceEventKind::Renamed);
  EXPECT_EQ(e.label, 2u);
  EXPECT_EQ(e.other, 1u);
  EXPECT_EQ(rig.world.surface.counters.splits, 0);
}

TEST(Components, ADropWithoutSurfelsIsAComponent) {
  SerialSurfaceRig rig;
  rig.ball({0, 0, 0}, 0.5, 1);
  rig.particle({0, 0, 1}, 1);
  rig.particle({0, 0, 1.1}, 1);
  rig.update();
  ASSERT_EQ(rig.components().size(), 2u);
  EXPECT_EQ(rig.components()[1].particles, 2);
  EXPECT_EQ(rig.components()[1].surfels, 0);
}

TEST(Components, ParticleInsideTheSurfaceKeepsItsComponent) {
  SerialSurfaceRig rig;
  for (int z = -2; z < 2; z++)
    for (int y = -2; y < 2; y++)
      // farther apart than links
      for (int x = -2; x < 2; x++) rig.particle({0.16 * (x + 0.5), 0.16 * (y + 0.5), 0.16 * (z + 0.5)}, 1);
  rig.sphere({0, 0, 0}, 0.5, 1);
  rig.particle({1.0, 0, 0}, 1);
  rig.update();
  ASSERT_EQ(rig.components().size(), 2u);
  EXPECT_EQ(rig.components()[0].label, 1u);
  EXPECT_EQ(rig.components()[0].particles, 64);
  EXPECT_EQ(rig.world.surface.counters.splits, 1);
}

TEST(Components, SurfelsWithoutParticlesAreDeletedAndCounted) {
  SerialSurfaceRig rig;
  rig.ball({0, 0, 0}, 0.5, 1);
  const std::uint64_t before = rig.surfels;
  rig.sphere({1.3, 0, 0}, 0.2, 1);
  rig.update();
  ASSERT_EQ(rig.components().size(), 1u);
  EXPECT_EQ(rig.components()[0].surfels, static_cast<std::int64_t>(before));
  EXPECT_EQ(rig.world.surface.counters.lost, static_cast<std::int64_t>(rig.surfels - before));
}

TEST(Components, NewParticlesTakeTheComponentThatTheyTouch) {
  SerialSurfaceRig rig;
  rig.ball({0, 0, 0}, 0.5, 1);
  rig.ball({1.2, 0, 0}, 0.3, 1 + rig.particles);
  // a column on the first ball, connected step by step
  for (int k = 0; k < 4; k++) rig.particle({0, 0, 0.55 + 0.1 * k});
  rig.particle({0, 0, -1.5});
  rig.update();
  ASSERT_EQ(rig.components().size(), 3u);
  const std::vector<std::uint64_t> label = rig.labels();
  for (std::size_t k = 2; k < 6; k++) EXPECT_EQ(label[label.size() - k], 1u);
  EXPECT_EQ(label.back(), label.size());
  EXPECT_EQ(rig.world.surface.counters.splits, 0);
}

TEST(Components, NewParticlesFollowTheMergeRules) {  // four particles of another body next to a ball
  struct Rule {
    MergeRule merge;
    bool ballIsLiquid, theyAreLiquid, join;
  };
  for (const Rule& r :
       {Rule{MergeRule::None, true, true, false}, Rule{MergeRule::Liquid, true, true, true},
        Rule{MergeRule::Liquid, false, true, true}, Rule{MergeRule::Liquid, false, false, false},
        Rule{MergeRule::All, false, false, true}}) {
    SerialSurfaceRig rig;
    rig.world.scene.surface.merge = r.merge;
    rig.liquid = r.ballIsLiquid;
    rig.ball({0, 0, 0}, 0.5, 1);
    rig.particle({0, 0, -0.55});  // and one of its own body
    rig.body = 1;
    rig.liquid = r.theyAreLiquid;
    const std::uint64_t first = rig.particles;
    for (int k = 0; k < 4; k++) rig.particle({0, 0, 0.55 + 0.1 * k});
    rig.update();
    const std::vector<std::uint64_t> label = rig.labels();
    ASSERT_EQ(rig.components().size(), r.join ? 1u : 2u);
    EXPECT_EQ(label[first - 1], 1u);
    for (std::size_t k = first; k < label.size(); k++) EXPECT_EQ(label[k], r.join ? 1u : 1 + first);
  }
}

TEST(Components, AThinSheetIsOneBody) {  // stability row 20: two layers of particles, sides closer than 2 h
  SerialSurfaceRig rig;
  rig.box({-1, -1, 0}, {20, 20, 2});
  rig.update();
  ASSERT_EQ(rig.components().size(), 1u);
  EXPECT_NEAR(rig.components()[0].volume, 0.8, 0.008);
  EXPECT_NEAR(rig.components()[0].area, 2 * 4 + 4 * 2 * 0.2, 0.01);
}

TEST(Components, ASprayOfAThousandDropsIsFast) {
  SerialSurfaceRig rig(0.05, {0, 0, 0}, {10, 10, 10});
  for (int k = 0; k < 1000; k++) {
    const Vec3d c{0.5 + k % 10, 0.5 + k / 10 % 10, 0.5 + k / 100};
    const double R = 0.06 + 0.15 * randomUniform(1, Purpose::Test, static_cast<std::uint64_t>(k));
    rig.ball(c, R);
  }
  const auto start = std::chrono::steady_clock::now();
  rig.update();
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  EXPECT_EQ(rig.components().size(), 1000u);
  std::printf("1000 drops, %llu particles, %llu surfels: %.3f s\n",
              static_cast<unsigned long long>(rig.particles), static_cast<unsigned long long>(rig.surfels),
              seconds);
}
