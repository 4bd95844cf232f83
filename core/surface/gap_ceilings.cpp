#include "core/surface/gap_ceilings.hpp"

#include <algorithm>
#include <limits>

#include "core/surface/near_sheets.hpp"

namespace thaw {

void findCeilings(Surface& s, const std::vector<std::uint8_t>& free, const Bins& bins, double reach, bool again) {
  Surfels& f = s.surfels;
  constexpr float none = std::numeric_limits<float>::infinity();
  for (std::size_t i = 0; i < f.owned; i++) {
    if (again && (!free[i] || f.ceiling[i] == none)) continue;
    f.ceiling[i] = none;
    if (!free[i]) continue;
    const Vec3d x = f.position[i], n = f.normal[i];
    double lowest = std::numeric_limits<double>::infinity();
    forRowsAround(bins, x, x, reach, [&](std::uint32_t j, const Vec3d&) {
      const Vec3d d = f.position[j] - x;
      const double height = dot(d, n), r2 = dot(d, d);
      if (height >= lowest || r2 > reach * reach || r2 - height * height > f.radius[j] * f.radius[j]) return;
      if (f.component[j] == f.component[i] && facing(d, n, f.normal[j]) == Facing::AcrossGap) lowest = height;
    });
    if (lowest < reach) f.ceiling[i] = static_cast<float>(std::max(lowest, leastCeiling * s.spacing));
  }
}

void packCeilings(const Surface& s, const GroupLists& lists, GapCeilings& c) {
  const Surfels& f = s.surfels;
  c.any = false;
  c.height.resize(f.size());
  for (std::size_t i = 0; i < f.owned; i++) c.height[i] = f.ceiling[i] / static_cast<float>(s.grid.support);
  c.ofGroup.assign(lists.groups(), 0);
  for (std::size_t g = 0; g < lists.groups(); g++)
    for (std::size_t lane = 0; lane < static_cast<std::size_t>(lists.lanes[g]); lane++)
      if (c.height[lists.self[8 * g + lane]] < std::numeric_limits<float>::infinity()) c.ofGroup[g] = 1, c.any = true;
}

}  // namespace thaw
