// SPDX-License-Identifier: Apache-2.0
#include "core/surface/search/row_lists.hpp"

namespace thaw {

void findRows(const Bins& bins, const Vec3d* position, std::size_t owned,
              const std::vector<std::uint8_t>& wanted, double radius, RowLists& lists) {
  lists.row.clear();
  lists.first.assign(owned, 0);
  lists.end.assign(owned, 0);
  const double r2 = radius * radius;
  std::vector<std::uint32_t> queries;
  for (std::size_t b = 0; b < bins.size(); b++) {
    queries.clear();
    for (std::uint32_t k = bins.first[b]; k < bins.first[b + 1]; k++)
      if (bins.row[k] < owned && wanted[bins.row[k]]) queries.push_back(bins.row[k]);
    if (queries.empty()) continue;
    PlaceBox box{position[queries[0]], position[queries[0]]};
    for (const std::uint32_t i : queries) box.add(position[i]);
    lists.block.find(bins, box, radius);
    for (const std::uint32_t i : queries) {
      const Vec3d x = position[i];
      std::size_t n = lists.first[i] = lists.row.size();
      const std::span<const std::uint32_t> near = lists.block.around(x, radius);
      lists.row.resize(n + near.size());
      for (const std::uint32_t k : near) {
        const Vec3d d = lists.block.at[k] - x;
        lists.row[n] = lists.block.row[k];
        n += (dot(d, d) < r2) & (lists.block.row[k] != i);
      }
      lists.row.resize(n);
      lists.end[i] = n;
    }
  }
}

}  // namespace thaw
