// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/shapes/pose.hpp"

#include <gtest/gtest.h>

namespace thaw {
namespace {

const std::vector<Keyframe> motion{
    {1, {0, 0, 0}, {0.1, 0.2, 0.3}}, {3, {2, 4, 0}, {1.1, -0.4, 0.9}}, {4, {2, 4, 1}, {1.1, -0.4, 0.9}}};

TEST(Pose, IsLinearBetweenKeyframesAndConstantOutside) {
  EXPECT_EQ(poseAt(motion, 0).move, (Vec3d{0, 0, 0}));
  EXPECT_EQ(poseAt(motion, 0).velocity, (Vec3d{}));
  EXPECT_EQ(poseAt(motion, 2).move, (Vec3d{1, 2, 0}));
  EXPECT_EQ(poseAt(motion, 2).velocity, (Vec3d{1, 2, 0}));
  EXPECT_EQ(poseAt(motion, 3).velocity, (Vec3d{0, 0, 1}));
  EXPECT_EQ(poseAt(motion, 9).move, (Vec3d{2, 4, 1}));
  EXPECT_EQ(poseAt(motion, 4).velocity, (Vec3d{}));
  const Vec3d x{0.3, 0.7, 0.1};
  EXPECT_EQ(toRest(poseAt({}, 5), x), x);
  // a jump
  EXPECT_EQ(poseAt({{1, {}, {}}, {1, {5, 0, 0}, {}}, {1, {6, 0, 0}, {}}}, 1).move, (Vec3d{6, 0, 0}));
}

TEST(Pose, RoundTripsPoints) {
  const Pose p = poseAt(motion, 2.3);
  const Vec3d x{0.3, -0.7, 1.1};
  EXPECT_LT(length(fromRest(p, toRest(p, x)) - x), 1e-15);
  EXPECT_LT(length(directionFromRest(p, x) + p.move - fromRest(p, x)), 1e-15);
}

TEST(Pose, VelocityIsTheDerivative) {
  for (const double t : {1.2, 2.0, 2.7, 3.5}) {
    const double h = 1e-6;
    for (const Vec3d& rest : {Vec3d{0.5, 0.2, -0.3}, Vec3d{-1, 2, 0.7}}) {
      const Vec3d x = fromRest(poseAt(motion, t), rest);
      const Vec3d v = (fromRest(poseAt(motion, t + h), rest) - fromRest(poseAt(motion, t - h), rest)) /
                      (2 * h);
      EXPECT_LT(length(velocityAt(poseAt(motion, t), x) - v), 1e-8);
    }
  }
}

}  // namespace
}  // namespace thaw
