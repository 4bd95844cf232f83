// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/basic/signed_distance.hpp"

#include <algorithm>
#include <cmath>

namespace thaw {

void SignedDistance::insideAlong(std::span<const Vec3d> points, std::span<std::uint8_t> in,
                                 KnownSides&) const {
  const std::size_t n = points.size();
  const double spacing = n > 1 ? length(points[1] - points[0]) : 1;
  for (std::size_t k = 0; k < n;) {
    if (hasGaps()) {
      in[k] = inside(points[k]);
      k++;
      continue;
    }
    // Points closer than the surface are on the same side. Far from the surface, the sign and a lower bound
    // cost less than the exact distance.
    const double d = distanceWithin(points[k], 0.01 * spacing);
    const auto same = 1 + static_cast<std::size_t>(std::min(std::abs(d) / spacing * (1 - 1e-9), 1e9));
    const std::size_t end = std::min(n, k + same);
    for (; k < end; k++) in[k] = d < 0;
  }
}

double SignedDistance::extent(const Vec3d& direction) const {
  const Bounds b = bounds();
  double e = 0;
  for (int a = 0; a < 3; a++)
    // This avoids 0 times infinity.
    if (direction[a] != 0) e += direction[a] * (direction[a] > 0 ? b.max[a] : b.min[a]);
  return e;
}

double SignedDistance::outerExtent(const Vec3d&) const { return never; }

Bounds boundsFromExtents(const SignedDistance& shape) {
  return {{-shape.extent({-1, 0, 0}), -shape.extent({0, -1, 0}), -shape.extent({0, 0, -1})},
          {shape.extent({1, 0, 0}), shape.extent({0, 1, 0}), shape.extent({0, 0, 1})}};
}

}  // namespace thaw
