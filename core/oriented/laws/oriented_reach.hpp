// SPDX-License-Identifier: Apache-2.0
// Range of the interaction of oriented particles.
#pragma once
#include <algorithm>

#include "core/scene/scene.hpp"

namespace thaw {

/// Returns the smallest length (m) of cells for oriented particles: 1.1 times their largest interaction
/// radius.
inline double orientedReach(const Scene& s) {
  double reach = 0;
  for (const OrientedBody& b : s.oriented) reach = std::max(reach, 1.1 * b.support * spacingOf(s, b));
  return reach;
}

}  // namespace thaw
