#include "core/surface/row_lists.hpp"

namespace thaw {

void findRows(const Bins& bins, const Vec3d* position, std::size_t owned, const std::vector<std::uint8_t>& wanted, double radius, RowLists& lists) {
  lists.row.clear();
  lists.first.assign(owned + 1, 0);
  const double r2 = radius * radius;
  for (std::size_t i = 0; i < owned; i++) {
    if (wanted[i]) {
      const Vec3d x = position[i];
      forRowsAround(bins, x, x, radius, [&](std::uint32_t j, const Vec3d& at) {
        const Vec3d d = at - x;
        if (dot(d, d) < r2 && i != j) lists.row.push_back(j);
      });
    }
    lists.first[i + 1] = lists.row.size();
  }
}

}  // namespace thaw
