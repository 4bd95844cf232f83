// SPDX-License-Identifier: Apache-2.0
// Least-squares fits in the tangent plane of a free surface (surface_curvature.hpp).
#pragma once
#include <algorithm>

#include "core/math/tangent.hpp"

namespace thaw {

/// Least-squares sums in the tangent plane of a particle. Lengths in support radii.
struct TangentFit {
  Vec3d outwards, first, second;                               // normal and tangents
  double xx = 0, xy = 0, yy = 0;                               // moments
  double slope[2][2] = {{0, 0}, {0, 0}}, tension[2] = {0, 0};  // slopes of normal and tension
  double number;                                               // sum of the kernel of a plane
  double depth = 0;                                            // sum of depths below the plane

  TangentFit(const Vec3d& normal, double own)
      : outwards(normal), first(anyTangent(normal)), second(cross(normal, first)), number(own) {}

  void add(double weight, const Vec3d& d, const Vec3d& turn, double rise) {
    const double x = dot(d, first), y = dot(d, second), u = dot(turn, first), v = dot(turn, second);
    const double near = std::max(1 - x * x - y * y, 0.0), w = weight * (1 - dot(d, d));
    number += weight * near * near;
    depth -= w * dot(d, outwards);
    xx += w * x * x, xy += w * x * y, yy += w * y * y;
    slope[0][0] += w * x * u, slope[0][1] += w * x * v;
    slope[1][0] += w * y * u, slope[1][1] += w * y * v;
    tension[0] += w * x * rise, tension[1] += w * y * rise;
  }
  /// Adds the mirror image of a neighbour behind a wall. Without it, the area next to the wall would be too
  /// large.
  void addImage(double weight, const Vec3d& d) {
    const double near = std::max(1 - dot(d, d), 0.0);
    number += weight * near * near;
  }
  /// Sum of the principal curvatures times h of a paraboloid through the particle, from the depth of the
  /// neighbours below its tangent plane. Requires: solvable().
  double bulge() const { return 4 * depth / (xx + yy); }
  bool solvable() const { return xx + yy > 1e-3; }
  /// Solves the fit. A small multiple of the identity bounds the slopes of particles with few neighbours.
  void solve() {
    const double small = 1e-3 * (xx + yy), a = xx + small, b = yy + small, det = a * b - xy * xy;
    const auto inverse = [&](double& s, double& t) {
      const double u = (b * s - xy * t) / det;
      t = (a * t - xy * s) / det;
      s = u;
    };
    inverse(slope[0][0], slope[1][0]), inverse(slope[0][1], slope[1][1]), inverse(tension[0], tension[1]);
  }
};

}  // namespace thaw
