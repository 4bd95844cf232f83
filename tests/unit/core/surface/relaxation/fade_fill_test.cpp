// SPDX-License-Identifier: Apache-2.0
#include "core/surface/advection/gather_particles.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace thaw {
namespace {

/// Remaining part of a fill of 1.4 after a displacement with this gradient.
double left(const Mat3d& gradient, float liquid, float fill = 1.4f) {
  SurfaceParticles p;
  for (AnyColumn* c : std::initializer_list<AnyColumn*>{&p.fill, &p.liquid, &p.gradient}) p.activate(*c);
  p.resize(1, 0);
  p.fill[0] = fill;
  p.liquid[0] = liquid;
  p.gradient[0] = gradient;
  fadeFill(p);
  return static_cast<double>(p.fill[0]);
}

TEST(FadeFill, FollowsTheStrainOfTheLiquidPart) {
  const Mat3d stretched{{{0.3, 0, 0}, {0, 0, 0}, {0, 0, 0}}}, turned{{{0, -0.3, 0}, {0.3, 0, 0}, {0, 0, 0}}};
  EXPECT_NEAR(left(stretched, 1), 1 + 0.4 / std::exp(1), 1e-6);
  EXPECT_NEAR(left(stretched, 0.5f), 1 + 0.4 / std::exp(0.5), 1e-6);
  EXPECT_FLOAT_EQ(static_cast<float>(left(stretched, 0)), 1.4f);
  EXPECT_FLOAT_EQ(static_cast<float>(left(turned, 1)), 1.4f);
  EXPECT_EQ(left(stretched, 1, 0), 0) << "zero stays zero";
}

}  // namespace
}  // namespace thaw
