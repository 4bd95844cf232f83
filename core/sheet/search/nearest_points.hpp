// SPDX-License-Identifier: Apache-2.0
// Nearest points of a point and a triangle, and of two edges, as weights of their vertices. Mesh contact
// distributes forces by these weights.
#pragma once
#include "core/math/vec3.hpp"

namespace thaw {

/// Returns the barycentric coordinates of the triangle's point that is nearest to x.
Vec3d sharesOfNearest(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& x);

/// Parameters of the nearest points along two edges, 0 to 1.
struct EdgeShares {
  double first, second;
};

/// Returns the nearest points of the edges from p along u and from q along v. For parallel edges, they are
/// not unique.
EdgeShares nearestOfEdges(const Vec3d& p, const Vec3d& u, const Vec3d& q, const Vec3d& v);

}  // namespace thaw
