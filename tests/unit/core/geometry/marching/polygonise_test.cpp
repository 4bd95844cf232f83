// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/marching/polygonise.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/geometry/builtin/bust.hpp"
#include "tests/support/closed_mesh.hpp"
#include "tests/support/meshes.hpp"

using namespace thaw;

TEST(Polygonise, BallsConvergeToTheirVolume) {
  double before = 0;
  for (const double spacing : {0.2, 0.1, 0.05}) {
    const TriangleMesh ball = ballMesh({0.013, -0.007, 0.021}, 1, spacing);
    expectClosed(ball);
    const double error = 4 * std::numbers::pi / 3 - volumeOf(ball);  // chords lie inside
    EXPECT_GT(error, 0);
    // A triangle in a cube of edge h is within 3/4 h^2 / 2 of the sphere of radius 1.
    EXPECT_LT(error, 4 * std::numbers::pi * 0.375 * spacing * spacing);
    if (before > 0) {
      EXPECT_NEAR(before / error, 4, 0.4);  // second order
    }
    before = error;
  }
}

// Balls that touch give cubes with diagonal corners inside.
TEST(Polygonise, TouchingBallsAreClosed) {
  const auto value = [](const Vec3d& x) {
    return std::min(length(x - Vec3d{0.31, 0.29, 0.3}), length(x + Vec3d{0.31, 0.29, 0.3})) - 0.52;
  };
  for (const double spacing : {0.03, 0.05, 0.11}) {
    const TriangleMesh mesh = polygonise(value, {{-1, -1, -1}, {1, 1, 1}}, spacing);
    expectClosed(mesh);
    EXPECT_GT(volumeOf(mesh), 0);
  }
}

// The oracle counts points inside on a grid.
TEST(Polygonise, BustHasTheVolumeOfItsField) {
  const TriangleMesh bust = bustMesh();
  expectClosed(bust);
  constexpr double step = 0.0073;
  double volume = 0;
  for (double z = 0.5 * step; z < 1; z += step)
    for (double y = -0.3; y < 0.3; y += step)
      for (double x = -0.3; x < 0.3; x += step)
        if (bustValue({x, y, z}) < 0) volume += step * step * step;
  EXPECT_NEAR(volumeOf(bust) / volume, 1, 0.005);
}
