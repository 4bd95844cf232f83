// SPDX-License-Identifier: Apache-2.0
// Depth of a particle in all triangles within reach, as one smooth value.
#pragma once
#include <algorithm>
#include <cmath>

#include "core/math/vec3.hpp"

namespace thaw {

/// Depth (sum of d_i^8)^(1/8) over all triangles within reach. d_i = reach - distance, as a fraction of the
/// reach. n_i points from the particle to the nearest point of triangle i.
///
/// The depth in the nearest triangle has no continuous gradient. On a sagging sheet, the nearest triangle
/// changes within a step, and the force turns abruptly. The sheet then gains energy at any step size. The
/// depth above is smooth. Away from edges, it equals the depth in the nearest triangle. It is 1.09 times as
/// large over an edge, and 1.25 times over a vertex of six triangles. The stiffness grows with the square of
/// these factors. The power 4 (1.19, 1.57) would need shorter steps.
struct FaceDepth {
  double sum = 0;        ///< sum of d_i^8
  double sumDepth7 = 0;  ///< sum of d_i^7
  double sumDepth6 = 0;  ///< sum of d_i^6
  Vec3d slopes{};        ///< sum of d_i^7 n_i

  /// Returns d^7, a triangle's part of the gradient up to a common factor.
  static double push(double d) {
    const double d2 = d * d;
    return d2 * d2 * d2 * d;
  }
  void add(double d, const Vec3d& n) {
    const double d7 = push(d);
    sum += d7 * d;
    sumDepth7 += d7;
    sumDepth6 += d7 / d;
    slopes += d7 * n;
  }
  double depth() const { return std::sqrt(std::sqrt(std::sqrt(sum))); }
  double perPush() const { return depth() / sum; }
  Vec3d slope() const { return slopes * perPush(); }
  /// Bounds the second derivative of the depth. The slope of the force is at most E'' gradient^2 + E' times
  /// this. It is 0 if all triangles have the same direction.
  double secondDerivative() const {
    const double d = depth();
    return 7 / d * std::max(0.0, sumDepth6 * d * d / sum - dot(slope(), slope()));
  }
};

}  // namespace thaw
