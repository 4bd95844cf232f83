// SPDX-License-Identifier: Apache-2.0
// Faces of a wall near a point. A concave corner has several faces, and each supports liquid.
#pragma once
#include <array>
#include <cstddef>

#include "core/geometry/basic/signed_distance.hpp"

namespace thaw {

struct Face {
  double distance;  ///< m, to the face's plane; negative inside the wall
  Vec3d normal;     ///< out of the wall
};

struct Faces {
  static constexpr std::size_t most = 3;
  std::array<Face, most> face;
  std::size_t count = 0;
};

/// Returns the faces within `reach` (m) of x, nearest first. All faces except the nearest must be plane
/// around the projection of x, within a twentieth of `spacing` (m). Curved surfaces and convex edges count as
/// one face. Empty if the surface is out of reach.
Faces facesWithin(const SignedDistance& shape, const Vec3d& x, double reach, double spacing);

}  // namespace thaw
