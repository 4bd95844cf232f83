// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/shapes/shape_volume.hpp"

#include <gtest/gtest.h>

#include "core/halo/serial.hpp"

namespace thaw {
namespace {

double volumeOf(const Shape& shape) {
  SerialReducer all;
  const Shape* const one[] = {&shape};
  return shapeVolumes(one, {}, all).front();
}

/// Volume of a union of the shape alone, which has no formula and is sampled.
double sampledVolumeOf(const Shape& shape) {
  Shape joined;
  joined.kind = ShapeKind::Union;
  joined.parts = {shape};
  return volumeOf(joined);
}

TEST(ShapeVolume, IsExactForKnownShapes) {
  Shape s;
  s.kind = ShapeKind::Box;
  s.size = {0.3, 0.02, 0.1};  // a plate far thinner than long
  s.scale = 2;
  EXPECT_NEAR(volumeOf(s), 48e-4, 1e-15);
  EXPECT_NEAR(sampledVolumeOf(s), 48e-4, 1e-11);
  s.scale = 1;
  s.kind = ShapeKind::Sphere;
  s.radius = 0.4;
  EXPECT_NEAR(sampledVolumeOf(s) / volumeOf(s), 1, 1e-3);
  s.kind = ShapeKind::Cylinder;
  s.height = 0.5;
  EXPECT_NEAR(sampledVolumeOf(s) / volumeOf(s), 1, 2e-3);
  s.kind = ShapeKind::Torus;
  s.radius = 0.4, s.radius2 = 0.05;
  EXPECT_NEAR(sampledVolumeOf(s) / volumeOf(s), 1, 3e-3);
  s.kind = ShapeKind::HalfSpace;
  EXPECT_EQ(volumeOf(s), 0);
}

}  // namespace
}  // namespace thaw
