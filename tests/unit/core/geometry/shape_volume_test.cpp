#include "core/geometry/shape_volume.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "core/halo/serial.hpp"

namespace thaw {
namespace {

double volumeOf(const Shape& shape) {
  SerialReducer all;
  return shapeVolume(*makeSignedDistance(shape), all);
}

TEST(ShapeVolume, OfShapesWhoseVolumeIsKnown) {
  Shape s;
  s.kind = ShapeKind::Box;
  s.size = {0.3, 0.02, 0.1};  // a plate far thinner than long
  EXPECT_NEAR(volumeOf(s), 6e-4, 1e-12);
  s.kind = ShapeKind::Sphere;
  s.radius = 0.4;
  EXPECT_NEAR(volumeOf(s) / (4.0 / 3 * std::numbers::pi * 0.064), 1, 1e-3);
  s.kind = ShapeKind::Torus;
  s.radius = 0.4, s.radius2 = 0.05;
  EXPECT_NEAR(volumeOf(s) / (2 * std::numbers::pi * std::numbers::pi * 0.4 * 0.0025), 1, 3e-3);
  s.kind = ShapeKind::HalfSpace;
  EXPECT_EQ(volumeOf(s), 0);
}

}  // namespace
}  // namespace thaw
