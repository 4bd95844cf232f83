// SPDX-License-Identifier: Apache-2.0
#include "core/domain/emit.hpp"

#include <gtest/gtest.h>

namespace thaw::test {
namespace {

Scene sceneWithEmitter() {
  Scene s;
  s.spacing = 0.01;
  s.domain.min = {-0.1, -0.1, 0};
  s.domain.max = {0.1, 0.1, 0.5};
  s.materials.emplace_back();
  s.emitters.emplace_back();
  Emitter& e = s.emitters[0];
  e.radius = 0.02;
  e.centre = {0, 0, 0.3};
  e.direction = {0, 0, -1};
  e.speed = 2;
  e.start = 1;
  e.end = 2;
  return s;
}

}  // namespace

TEST(Emitter, NozzleHoldsTheLayersWithinTheSupportRadius) {
  Scene s = sceneWithEmitter();
  const EmitterPlan p = planEmitters(s)[0];
  EXPECT_EQ(p.layer.size(), 12u);
  EXPECT_DOUBLE_EQ(p.interval, 0.005);
  EXPECT_DOUBLE_EQ(p.ahead, 2 * p.interval);
  const Emitter& e = s.emitters[0];
  EXPECT_EQ(layersUntil(e, p, 0.999), 0);
  EXPECT_EQ(layersUntil(e, p, 1), 3);  // one in the opening, two behind it
  EXPECT_EQ(layersUntil(e, p, 1.0051), 4);
  EXPECT_EQ(layersUntil(e, p, 100), 201);  // the last leaves at the end
  EXPECT_DOUBLE_EQ(leavingTime(e, p, 200), 2);
}

TEST(Emitter, NozzleEndsAtTheDomain) {
  Scene s = sceneWithEmitter();
  s.domain.max.z = 0.315;
  EXPECT_DOUBLE_EQ(planEmitters(s)[0].ahead, 0.005);
  s.domain.max.z = 0.305;
  EXPECT_EQ(planEmitters(s)[0].ahead, 0);
}

TEST(Emitter, ReportsAMismatchedRate) {
  Scene s = sceneWithEmitter();
  s.emitters[0].rate = 100;
  EXPECT_THROW(planEmitters(s), std::runtime_error);
}

TEST(Emitter, ReleasesParticlesThatHaveLeft) {
  const Scene s = sceneWithEmitter();
  const auto plans = planEmitters(s);
  Continuum p;
  p.activate(p.id);
  p.activate(p.clamped);
  p.resize(4, 0);
  for (std::size_t layer = 0; layer < 3; layer++) {
    p.id[layer] = particleId(0, layer * plans[0].layer.size() + 5);
    p.clamped[layer] = driven;
  }
  p.clamped[3] = fixedInPlace;
  releaseDriven(s, plans, 1.006, p);
  EXPECT_EQ(p.clamped[0], 0);
  EXPECT_EQ(p.clamped[1], 0);
  EXPECT_EQ(p.clamped[2], driven);
  EXPECT_EQ(p.clamped[3], fixedInPlace);
}

}  // namespace thaw::test
