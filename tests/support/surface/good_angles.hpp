// SPDX-License-Identifier: Apache-2.0
// Check of the shapes of triangles.
#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "core/geometry/basic/triangle_mesh.hpp"
#include "io/surface_mesh/triangle_angles.hpp"

namespace thaw {

/// Checks that no angle is below 5 degrees, and at most one triangle in a thousand has one below 15.
inline void expectGoodAngles(const TriangleMesh& mesh) {
  constexpr double degree = std::numbers::pi / 180;
  std::size_t sharp = 0;
  double least = std::numbers::pi;
  for (const auto& t : mesh.triangles) {
    const double angle = smallestAngle(mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]);
    least = std::min(least, angle);
    sharp += angle < 15 * degree;
  }
  EXPECT_GT(least, 5 * degree);
  EXPECT_LE(1000 * sharp, mesh.triangles.size());
}

}  // namespace thaw
