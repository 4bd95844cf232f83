// Faces of a wall near a point: in a concave corner a wall has several, and each supports a liquid.
#pragma once
#include <array>
#include <cstddef>

#include "core/geometry/signed_distance.hpp"

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

/// Faces within `reach` (m) of x, the nearest first. Further faces must be plane where x projects onto them,
/// to within a twentieth of `spacing` (m): curved surfaces and convex edges count as one face. None where the
/// surface is not within reach.
Faces facesWithin(const SignedDistance& shape, const Vec3d& x, double reach, double spacing);

}  // namespace thaw
