// SPDX-License-Identifier: Apache-2.0
// Part of a body outside the domain: number of particles, sides and distance.
#pragma once
#include <cstdint>
#include <string>

#include "core/halo/halo.hpp"
#include "core/scene/scene.hpp"

namespace thaw {

struct Outside {
  std::int64_t count = 0;
  double beyond[3][2] = {{-1, -1}, {-1, -1}, {-1, -1}};  ///< m, [axis][low, high], distance of the farthest
                                                         ///< position beyond the side; below 0: no position
                                                         ///< is outside
  /// Records a position if it is outside; returns true if it is.
  bool look(const Domain& domain, const Vec3d& x);
};

/// Sums each element over all ranks. Collective.
void addUp(std::span<Outside> all, Reducer& reducer);

/// Returns "60 of its 125 particles lie outside of the domain, up to 0.05 m beyond its side x = 0.5 m;
/// enlarge the domain or move the body". rows: name of the counted items; what: name of the object to move.
std::string outsideText(const Outside& outside, const Domain& domain, std::int64_t all, const char* rows,
                        const char* what);

}  // namespace thaw
