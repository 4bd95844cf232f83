#include "core/surface/active_surfels.hpp"

#include <algorithm>

#include "core/surface/place_rows.hpp"
#include "core/surface/small_drops.hpp"

namespace thaw {
namespace {

/// Of the owned surfels of `free` those that are within reach of one of `from`. By true distances, so that it is the same on any number of ranks.
void markNear(const Surfels& f, const Bins& bins, const std::uint8_t* from, double reach, const std::vector<std::uint8_t>& free, std::vector<std::uint8_t>& to) {
  to.assign(f.owned, 0);
  const double reach2 = reach * reach;
  for (std::size_t j = 0; j < f.size(); j++) {
    if (!from[j]) continue;
    const Vec3d x = f.position[j];
    forRowsAround(bins, x, x, reach, [&](std::uint32_t i, const Vec3d& place) {
      if (i < f.owned && free[i] && dot(place - x, place - x) < reach2) to[i] = 1;
    });
  }
}

}  // namespace

void markFree(const Surface& s, bool all, std::vector<std::uint8_t>& free) {
  const Surfels& f = s.surfels;
  free.assign(f.owned, all);
  if (all) return;
  SmallDrops small(s);
  for (std::size_t i = 0; i < f.owned; i++) free[i] = settles(f, i) && !small(f.component[i]);
}

void markActive(Surface& s, CellHalo& halo, const Bins& bins, double reach, std::vector<std::uint8_t>& free, std::vector<std::uint8_t>& core) {
  Surfels& f = s.surfels;
  markNear(f, bins, f.moving.data(), reach, free, core);
  std::copy_n(core.begin(), f.owned, f.wish.data());
  refreshGhosts(halo, f, ColumnList{&f.wish});
  std::vector<std::uint8_t> listed;
  markNear(f, bins, f.wish.data(), reach, free, listed);
  free = std::move(listed);
}

}  // namespace thaw
