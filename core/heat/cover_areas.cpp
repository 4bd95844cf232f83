// SPDX-License-Identifier: Apache-2.0
#include "core/heat/cover_areas.hpp"

#include <algorithm>

#include "core/heat/exposed_area.hpp"

namespace thaw {
namespace {

/// Returns the fraction of a wall's covered area that another wall does not cover as well. Walls at a corner
/// cover different areas. aligned: alignment of the two normals.
double uncoveredShare(double covered, double other, double aligned) {
  return 1 - std::max(0.0, aligned) * other * other / std::max(covered * covered + other * other, 1e-30);
}

}  // namespace

void coverAreas(const WallView& w, const WallContacts& contacts) {
  const ExposedAreaLaw law = exposedAreaLaw(w.scene.numerics);
  const auto areaAt = [&](const WallContact& c) { return coveredArea(law, c.distance / w.scene.spacing); };
  const auto end = contacts.list.end();
  for (auto first = contacts.list.begin(), last = first; first != end; first = last) {
    double covered = 0;
    last = std::find_if(first, end, [&](const WallContact& c) { return c.row != first->row; });
    float& area = w.particles.exposedArea[first->row];
    for (auto c = first; area > 0 && c != last; ++c) {
      const double full = areaAt(*c);
      double share = 1;
      for (auto other = first; full > 0 && other != last; ++other)
        if (other != c) share *= uncoveredShare(full, areaAt(*other), alignment(c->normal, other->normal));
      covered += share * full;
    }
    if (covered > 0) area = static_cast<float>(clearArea(std::max(0.0, static_cast<double>(area) - covered)));
  }
}

}  // namespace thaw
