// How deep a particle is in a sheet of triangles: one smooth number of all of those within reach.
#pragma once
#include <algorithm>
#include <cmath>

#include "core/math/vec3.hpp"

namespace thaw {

/// The depth (sum of d_i^8)^(1/8) of all triangles within reach, at depths d_i = reach - distance in parts of
/// the reach; n_i from the particle to the nearest point of each.
///
/// The depth in the nearest one would do on a flat sheet. Where a sheet sags under what lies on it another
/// one becomes the nearest within a step, the force turns at once, and a step of any length has that wrong by
/// a part of itself: a rubber cube on a net made 93 % of its energy anew. This one has a slope everywhere. It
/// is the depth in the nearest one away from edges, 1.09 times that over an edge and 1.25 times that over a
/// corner of six triangles, and as much stiffer squared; with the power 4 (1.19, 1.57) water on a coarse
/// cloth wants shorter steps.
struct FaceDepth {
  double sum = 0;     ///< of d_i^8
  double pushes = 0;  ///< of d_i^7
  double bends = 0;   ///< of d_i^6
  Vec3d slopes{};     ///< of d_i^7 n_i

  /// d^7: a triangle's part of the slope but for a factor of all.
  static double push(double d) {
    const double d2 = d * d;
    return d2 * d2 * d2 * d;
  }
  void add(double d, const Vec3d& n) {
    const double d7 = push(d);
    sum += d7 * d;
    pushes += d7;
    bends += d7 / d;
    slopes += d7 * n;
  }
  double depth() const { return std::sqrt(std::sqrt(std::sqrt(sum))); }
  double perPush() const { return depth() / sum; }
  Vec3d slope() const { return slopes * perPush(); }
  /// How much the slope bends, over the depth: times E'(depth) it stands beside E'' (slope)^2 in a bound of
  /// the force's slope. 0 where all triangles face the same way.
  double bend() const {
    const double d = depth();
    return 7 / d * std::max(0.0, bends * d * d / sum - dot(slope(), slope()));
  }
};

}  // namespace thaw
