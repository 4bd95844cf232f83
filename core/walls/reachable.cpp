// SPDX-License-Identifier: Apache-2.0
#include "core/walls/reachable.hpp"

namespace thaw {

void findReachable(const CellGrid& g, const Walls& walls, std::uint64_t key,
                   std::vector<std::uint32_t>& reachable) {
  const Vec3i c = cellOfKey(key);
  bool border = false;
  Vec3d centre;
  for (int a = 0; a < 3; a++) {
    border = border || (!g.periodic[a] && (c[a] <= 0 || c[a] >= g.cells[a] - 1));
    centre[a] = g.origin[a] + (c[a] + 0.5) * g.edge[a];
  }
  const double reach = g.support + (0.5 + 1e-6) * length(g.edge);
  reachable.clear();
  for (std::size_t k = 0; k < walls.list.size(); k++) {
    const Wall& wall = walls.list[k];
    if (!wall.present) continue;
    if (!border) {
      const Vec3d rest = toRest(wall.pose, centre);
      if (!nearBounds(wall.bounds, rest, reach) || wall.shape->distanceWithin(rest, 1.01 * reach) > reach)
        continue;
    }
    reachable.push_back(static_cast<std::uint32_t>(k));
  }
}

}  // namespace thaw
