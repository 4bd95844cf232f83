// SPDX-License-Identifier: Apache-2.0
#include "core/surface/search/group_lists.hpp"

#include <bit>

#include "core/surface/kernels/surface_kernels.hpp"

namespace thaw {
namespace {

// Spreads 21 bits, with two zero bits between adjacent ones.
std::uint64_t spread(std::uint64_t v) {
  v = (v | v << 32) & 0x1f00000000ffffull;
  v = (v | v << 16) & 0x1f0000ff0000ffull;
  v = (v | v << 8) & 0x100f00f00f00f00full;
  v = (v | v << 4) & 0x10c30c30c30c30c3ull;
  return (v | v << 2) & 0x1249249249249249ull;
}

/// Rows of a block of one component, relative to its middle, as separate arrays for vector instructions.
struct BlockRows {
  Vec3d from{};
  std::vector<std::uint32_t> row;
  std::vector<float> x, y, z;
  void take(const RowBlock& block, const Vec3d& middle, const std::uint64_t* component,
            std::uint64_t wanted) {
    from = middle;
    if (row.size() < block.count + nearBoxMore) {
      row.resize(block.count + nearBoxMore);
      for (auto* v : {&x, &y, &z}) v->resize(row.size());
    }
    count = 0;
    for (std::size_t k = 0; k < block.count; k++) {
      const Vec3d d = block.at[k] - from;
      row[count] = block.row[k];
      x[count] = static_cast<float>(d.x), y[count] = static_cast<float>(d.y),
      z[count] = static_cast<float>(d.z);
      count += component[block.row[k]] == wanted;
    }
  }
  /// Appends rows within `radius` (m) of a group's box, and slightly beyond. Farther rows add nothing to the
  /// sums of the group's surfels.
  void append(const PlaceBox& box, double radius, std::vector<std::uint32_t>& rows) {
    if (count == 0) return;
    const Vec3d middle = 0.5 * (box.low + box.high) - from, half = 0.5 * (box.high - box.low);
    NearBox near{};
    for (int a = 0; a < 3; a++)
      near.middle[a] = static_cast<float>(middle[a]), near.half[a] = static_cast<float>(half[a]);
    near.reach2 = static_cast<float>(1.0001 * radius * radius);
    const std::size_t before = rows.size();
    rows.resize(before + count + nearBoxMore);
    const std::size_t end = before + bestSurfaceKernels().nearBox(near, x.data(), y.data(), z.data(), count,
                                                                  &rows[before]);
    rows.resize(end);
    for (std::size_t n = before; n < end; n++) rows[n] = row[rows[n]];
  }

 private:
  std::uint32_t count = 0;
};

}  // namespace

void listGroups(const Surface& s, const std::vector<std::uint8_t>& free, const Bins& surfelBins,
                const Bins& particleBins, const ListRadii& radii, GroupLists& l) {
  const Surfels& f = s.surfels;
  // Eight surfels of a smooth surface cover about a block's side.
  const double curveEdge = 2.5 * s.spacing, longest = 6 * s.spacing;
  l.sorting.clear();
  std::uint64_t used = 0;
  bool several = false;
  for (std::uint32_t i = 0; i < f.owned; i++) {
    if (!free[i]) continue;
    std::uint64_t curve = 0;
    for (int a = 0; a < 3; a++)
      curve |= spread(static_cast<std::uint64_t>(
                   std::clamp((f.position[i][a] - surfelBins.base[a]) / curveEdge, 0.0, binsPerAxis)))
               << a;
    used |= curve;
    l.sorting.emplace_back(curve, i);
    several = several || f.component[i] != f.component[l.sorting[0].second];
  }
  sortByKey(l.sorting, l.sorted, std::bit_width(used));
  if (several)
    std::stable_sort(l.sorting.begin(), l.sorting.end(), [&](const auto& a, const auto& b) {
      return f.component[a.second] < f.component[b.second];
    });
  l.self.clear();
  l.lanes.clear();
  l.surfel.clear();
  l.particle.clear();
  l.firstSurfel.assign(1, 0);
  l.firstParticle.assign(1, 0);
  const auto place = [&](std::size_t k) { return f.position[l.sorting[k].second]; };
  RowBlock found;
  BlockRows surfels, particles;
  for (std::size_t k = 0; k < l.sorting.size();) {
    // a block of adjacent groups
    const std::uint64_t component = f.component[l.sorting[k].second];
    const auto boxFrom = [&](std::size_t from, std::size_t most, double side, std::size_t& to) {
      PlaceBox box{place(from), place(from)};
      for (to = from + 1;
           to < l.sorting.size() && to < from + most && f.component[l.sorting[to].second] == component;
           to++) {
        PlaceBox more = box;
        more.add(place(to));
        if (more.longest() > side) break;
        box = more;
      }
      return box;
    };
    std::size_t end = k;
    const PlaceBox block = boxFrom(k, 64, 2 * longest, end);
    const auto take = [&](const Bins& bins, double radius, const std::uint64_t* of, BlockRows& rows) {
      if (!(radius > 0)) return;
      found.find(bins, block, radius);
      rows.take(found, 0.5 * (block.low + block.high), of, component);
    };
    take(surfelBins, radii.surfels, f.component.data(), surfels);
    take(particleBins, radii.particles, s.particles.component.data(), particles);
    while (k < end) {
      std::size_t last = k;
      const PlaceBox box = boxFrom(k, std::min<std::size_t>(8, end - k), longest, last);
      for (std::size_t n = 0; n < 8; n++) l.self.push_back(l.sorting[std::min(k + n, last - 1)].second);
      l.lanes.push_back(static_cast<std::uint8_t>(last - k));
      surfels.append(box, radii.surfels, l.surfel);
      particles.append(box, radii.particles, l.particle);
      l.firstSurfel.push_back(l.surfel.size());
      l.firstParticle.push_back(l.particle.size());
      k = last;
    }
  }
}

}  // namespace thaw
