// SPDX-License-Identifier: Apache-2.0
// Sharp edges and corners of shapes near a point.
#pragma once
#include "core/geometry/basic/signed_distance.hpp"
#include "core/math/vec3.hpp"

namespace thaw {

/// Returns the vector (m) from x, a point inside of a shape, to the nearest point of a sharp convex edge, or
/// to a corner, within two spacings; zero if there is none.
Vec3d sharpEdge(const SignedDistance& shape, const Vec3d& x, double spacing);

}  // namespace thaw
