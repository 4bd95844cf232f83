// SPDX-License-Identifier: Apache-2.0
// Sharp edges and corners of shapes near a point.
#pragma once
#include <cmath>

#include "core/geometry/basic/signed_distance.hpp"
#include "core/math/vec3.hpp"

namespace thaw {

struct SharpEdge {
  Vec3d to{};     ///< m, from a point to the edge, where it is nearest, or to the corner; zero: none
  Vec3d along{};  ///< unit vector along the edge; zero: a corner, or a point of a curved edge
  double ahead = HUGE_VAL;   ///< m, from there to the end of the edge along it; infinite: not near
  double behind = HUGE_VAL;  ///< m, the same against the direction
};

/// Returns the sharp convex edge nearest to x, a point inside of a shape, or a corner, within two spacings.
SharpEdge sharpEdge(const SignedDistance& shape, const Vec3d& x, double spacing);

}  // namespace thaw
