// SPDX-License-Identifier: Apache-2.0
// Sharp edges and corners of shapes near a point.
#pragma once
#include <cmath>

#include "core/geometry/basic/signed_distance.hpp"
#include "core/math/vec3.hpp"

namespace thaw {

struct SharpEdge {
  Vec3d to{};     ///< m, from a point to the nearest point of the edge, or to the corner; zero: no edge
  Vec3d along{};  ///< unit vector along the edge; zero: a corner, or a point of a curved edge
  double ahead = HUGE_VAL;   ///< m, from that point to the end of the edge in the direction `along`;
                             ///< infinite: not near
  double behind = HUGE_VAL;  ///< m, the same in the opposite direction
};

/// Returns the sharp convex edge or corner nearest to x (m), within two spacings. Requires: x is inside the
/// shape.
SharpEdge sharpEdge(const SignedDistance& shape, const Vec3d& x, double spacing);

}  // namespace thaw
