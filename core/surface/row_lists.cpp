#include "core/surface/row_lists.hpp"

#include <algorithm>

namespace thaw {

void findRows(const CellGrid&, const CellTable& fromCells, const Vec3d* from, std::size_t owned, const CellTable& toCells, const Vec3d* to, double radius,
              bool same, RowLists& lists) {
  lists.row.clear();
  lists.first.assign(owned + 1, 0);
  const double r2 = radius * radius;
  for (std::size_t c = 0; c < fromCells.key.size(); c++) {
    if (fromCells.first[c] >= owned) continue;  // ghosts
    const Vec3i here = cellOfKey(fromCells.key[c]);
    std::size_t around[27];
    int cells = 0;
    for (int z = -1; z <= 1; z++)
      for (int y = -1; y <= 1; y++)
        for (int x = -1; x <= 1; x++) {
          const std::uint64_t key = cellKey({here.x + x, here.y + y, here.z + z});
          const auto at = std::lower_bound(toCells.key.begin(), toCells.key.end(), key);
          if (at != toCells.key.end() && *at == key) around[cells++] = static_cast<std::size_t>(at - toCells.key.begin());
        }
    for (std::uint32_t i = fromCells.first[c]; i < fromCells.first[c] + fromCells.count[c]; i++) {
      for (int k = 0; k < cells; k++)
        for (std::uint32_t j = toCells.first[around[k]]; j < toCells.first[around[k]] + toCells.count[around[k]]; j++) {
          const Vec3d d = to[j] - from[i];
          if (dot(d, d) < r2 && !(same && i == j)) lists.row.push_back(j);
        }
      lists.first[i + 1] = lists.row.size();
    }
  }
}

}  // namespace thaw
