// SPDX-License-Identifier: Apache-2.0
// Interval between evaluations of surface tension by curvature.
#include "core/flow/curvature/tension_interval.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/support/simulation.hpp"

namespace thaw::test {
namespace {

Scene dropOf(double viscosity) {
  Scene s = emptyScene(0.004, {-1, -1, -1}, {1, 1, 1});
  s.materials.emplace_back();
  s.materials[0].density = 900;
  s.materials[0].viscosity = {viscosity, viscosity};
  s.materials[0].surfaceTension = 0.03;
  addBox(s, {0, 0, 0}, {0.02, 0.02, 0.02});
  return s;
}

/// The step limit (s) of tension.
double limitOf(const Scene& s) {
  const double h = s.numerics.support * s.spacing;
  return s.numerics.cflTension * std::sqrt(900 * h * h * h / (2 * std::numbers::pi * 0.03));
}

}  // namespace

TEST(TensionInterval, IsATenthOfTheStepLimitInThickLiquids) {
  const Scene s = dropOf(10);
  EXPECT_NEAR(tensionInterval(s), 0.1 * limitOf(s), 1e-12);
}

TEST(TensionInterval, IsShortWhereViscosityDampsLittle) {
  const Scene s = dropOf(1e-3);
  EXPECT_NEAR(tensionInterval(s), 0.25 * 1e-3 * 0.004 / 0.03, 1e-12);
  EXPECT_LT(tensionInterval(s), 0.01 * limitOf(s));
}

TEST(TensionInterval, IsNoneWithoutTensionOrViscosity) {
  Scene s = dropOf(0);
  EXPECT_EQ(tensionInterval(s), 0);
  s = dropOf(10);
  s.materials[0].surfaceTension = 0;
  EXPECT_EQ(tensionInterval(s), 0);
  s = dropOf(10);
  s.materials[0].flowLaw.law = FlowLaw::Bingham;
  EXPECT_EQ(tensionInterval(s), 0);
}

TEST(TensionInterval, IsAWholeNumberOfSteps) {
  Clock clock;
  clock.dt = 1e-4;
  int due = 0;
  for (clock.step = 0; clock.step < 12; clock.step++) due += isTensionDue(4.5e-4, clock, 1e-4);
  EXPECT_EQ(due, 3);
  clock.step = 1;
  EXPECT_TRUE(isTensionDue(4.5e-4, clock, 0));     // at the start
  EXPECT_TRUE(isTensionDue(1.5e-4, clock, 1e-4));  // shorter than two steps
  EXPECT_FALSE(isTensionDue(2.5e-4, clock, 1e-4));
}

// The number of steps between evaluations follows the step, in powers of two.
TEST(TensionInterval, IsBoundedWhileTheStepChanges) {
  const double interval = 1e-3;
  for (const double growth : {0.97, 0.8, 1.03, 1.25}) {
    Clock clock;
    clock.dt = growth < 1 ? interval : 0.02 * interval;
    double since = 0;
    for (clock.step = 0; clock.step < 200; clock.step++) {
      since = isTensionDue(interval, clock, clock.dt) ? 0 : since + clock.dt;
      EXPECT_LT(since, 2 * interval);
      clock.dt = std::max(0.02 * interval, std::min(interval, clock.dt * growth));
    }
  }
}

}  // namespace thaw::test
