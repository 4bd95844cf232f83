// SPDX-License-Identifier: Apache-2.0
// Range of the interaction of oriented particles.
#pragma once
#include <algorithm>

#include "core/scene/scene.hpp"

namespace thaw {

/// Returns 1.1 times the largest radius (m) of interaction of oriented particles: the least length of cells.
inline double orientedReach(const Scene& s) {
  double reach = 0;
  for (const OrientedBody& b : s.oriented) reach = std::max(reach, 1.1 * b.support * spacingOf(s, b));
  return reach;
}

}  // namespace thaw
