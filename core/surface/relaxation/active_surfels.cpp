// SPDX-License-Identifier: Apache-2.0
#include "core/surface/relaxation/active_surfels.hpp"

#include <algorithm>

#include "core/surface/data/place_rows.hpp"
#include "core/surface/measures/small_drops.hpp"

namespace thaw {
namespace {

/// Sets `to` for the owned surfels of `free` that lie within `reach` of a surfel in `from`. Exact distances
/// give the same result on any number of ranks.
void markNear(const Surfels& f, const Bins& bins, const std::uint8_t* from, double reach,
              const std::vector<std::uint8_t>& free, std::vector<std::uint8_t>& to) {
  to.assign(f.owned, 0);
  const double reach2 = reach * reach;
  Bins sources;
  pickRows(bins, from, sources);
  RowBlock around;
  for (std::size_t b = 0; b < bins.size(); b++) {
    const PlaceBox box = boxOf(bins, b);
    const Vec3d across = box.high - box.low;
    // `all`: a source in the bin reaches the whole bin.
    bool all = false, any = false;
    for (std::uint32_t k = bins.first[b]; k < bins.first[b + 1]; k++) {
      all = all || (from[bins.row[k]] && dot(across, across) < reach2);
      any = any || (bins.row[k] < f.owned && free[bins.row[k]]);
    }
    if (!any) continue;
    if (!all) around.find(sources, box, reach);
    if (!all && around.count == 0) continue;
    for (std::uint32_t k = bins.first[b]; k < bins.first[b + 1]; k++) {
      const std::uint32_t i = bins.row[k];
      if (i >= f.owned || !free[i]) continue;
      to[i] = all ||
              std::any_of(around.at.begin(), around.at.begin() + static_cast<std::ptrdiff_t>(around.count),
                          [&](const Vec3d& x) {
                            const Vec3d d = bins.at[k] - x;
                            return dot(d, d) < reach2;
                          });
    }
  }
}

}  // namespace

void markFree(const Surface& s, bool all, std::vector<std::uint8_t>& free) {
  const Surfels& f = s.surfels;
  free.assign(f.owned, all);
  if (all) return;
  SmallDrops small(s);
  for (std::size_t i = 0; i < f.owned; i++) free[i] = mayRelax(f, i) && !small(f.component[i]);
}

void markActive(Surface& s, CellHalo& halo, const Bins& bins, double reach, std::vector<std::uint8_t>& free,
                std::vector<std::uint8_t>& core) {
  Surfels& f = s.surfels;
  markNear(f, bins, f.moving.data(), reach, free, core);
  std::copy_n(core.begin(), f.owned, f.resampleFlags.data());
  refreshGhosts(halo, f, ColumnList{&f.resampleFlags});
  std::vector<std::uint8_t> listed;
  markNear(f, bins, f.resampleFlags.data(), reach, free, listed);
  free = std::move(listed);
}

}  // namespace thaw
