// Nearest points of a point and a triangle, and of two edges, as shares of their corners: what a contact of
// meshes divides its force by.
#pragma once
#include "core/math/vec3.hpp"

namespace thaw {

/// The nearest point of a triangle to x: its shares of the corners (they add up to 1).
Vec3d sharesOfNearest(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& x);

/// How far along two edges, 0 to 1, their nearest points lie.
struct EdgeShares {
  double first, second;
};

/// Of the edges from p over the vector u, and from q over the vector v. Of parallel ones, whose nearest
/// points are many, some.
EdgeShares nearestOfEdges(const Vec3d& p, const Vec3d& u, const Vec3d& q, const Vec3d& v);

}  // namespace thaw
