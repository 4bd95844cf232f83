#include "core/surface/gap_ceilings.hpp"

#include <algorithm>
#include <limits>

#include "core/surface/near_sheets.hpp"

namespace thaw {

std::size_t findCeilings(const Surface& s, const std::vector<std::uint8_t>& free, const Bins& bins, double reach, const GroupLists& lists, GapCeilings& c) {
  const Surfels& f = s.surfels;
  std::size_t found = 0;
  c.height.assign(f.size(), std::numeric_limits<float>::infinity());
  for (std::size_t i = 0; i < f.owned; i++) {
    if (!free[i]) continue;
    const Vec3d x = f.position[i], n = f.normal[i];
    double lowest = std::numeric_limits<double>::infinity();
    forRowsAround(bins, x, x, reach, [&](std::uint32_t j, const Vec3d&) {
      const Vec3d d = f.position[j] - x;
      const double height = dot(d, n), r2 = dot(d, d);
      if (height >= lowest || r2 > reach * reach || r2 - height * height > f.radius[j] * f.radius[j]) return;
      if (f.component[j] == f.component[i] && facing(d, n, f.normal[j]) == Facing::AcrossGap) lowest = height;
    });
    if (!(lowest < reach)) continue;
    c.height[i] = static_cast<float>(std::max(lowest, leastCeiling * s.spacing));
    found++;
  }
  c.ofGroup.assign(lists.groups(), 0);
  for (std::size_t g = 0; found > 0 && g < lists.groups(); g++)
    for (std::size_t lane = 0; lane < lists.lanes[g]; lane++) c.ofGroup[g] |= c.height[lists.self[8 * g + lane]] < std::numeric_limits<float>::infinity();
  return found;
}

}  // namespace thaw
