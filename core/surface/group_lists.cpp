#include "core/surface/group_lists.hpp"

namespace thaw {
namespace {

std::uint64_t spread(std::uint64_t v) {  // 21 bits, two zeros between them
  v = (v | v << 32) & 0x1f00000000ffffull;
  v = (v | v << 16) & 0x1f0000ff0000ffull;
  v = (v | v << 8) & 0x100f00f00f00f00full;
  v = (v | v << 4) & 0x10c30c30c30c30c3ull;
  return (v | v << 2) & 0x1249249249249249ull;
}

/// Rows of `to` within `radius` of any of the places.
struct Collector {
  const Vec3d* at;
  int count;
  Vec3d low, high;
  void find(const Bins& bins, const std::uint64_t* component, std::uint64_t wanted, double radius, std::vector<std::uint32_t>& rows) const {
    const double r2 = radius * radius;
    forRowsAround(bins, low, high, radius, [&](std::uint32_t j, const Vec3d& x) {
      double box = 0;
      for (int a = 0; a < 3; a++) {
        const double d = std::max({low[a] - x[a], 0.0, x[a] - high[a]});
        box += d * d;
      }
      if (box >= r2 || component[j] != wanted) return;
      for (int k = 0; k < count; k++) {
        const Vec3d d = at[k] - x;
        if (dot(d, d) < r2) return rows.push_back(j);
      }
    });
  }
};

}  // namespace

void listGroups(const Surface& s, const std::vector<std::uint8_t>& free, const Bins& surfelBins, const Bins& particleBins, const ListRadii& radii, GroupLists& l) {
  const Surfels& f = s.surfels;
  const double block = 2.5 * s.spacing, longest = 6 * s.spacing;  // eight surfels of a smooth surface cover about a block's side
  l.sorting.clear();
  for (std::uint32_t i = 0; i < f.owned; i++) {
    if (!free[i]) continue;
    std::uint64_t curve = 0;
    for (int a = 0; a < 3; a++) curve |= spread(static_cast<std::uint64_t>(std::clamp((f.position[i][a] - surfelBins.base[a]) / block, 0.0, binsPerAxis))) << a;
    l.sorting.push_back({f.component[i], curve, i});
  }
  std::sort(l.sorting.begin(), l.sorting.end(), [](const auto& a, const auto& b) {
    return a.component != b.component ? a.component < b.component : a.curve != b.curve ? a.curve < b.curve : a.row < b.row;
  });
  l.self.clear();
  l.lanes.clear();
  l.surfel.clear();
  l.particle.clear();
  l.firstSurfel.assign(1, 0);
  l.firstParticle.assign(1, 0);
  for (std::size_t k = 0; k < l.sorting.size();) {
    Vec3d at[8];
    Collector here{at, 0, f.position[l.sorting[k].row], f.position[l.sorting[k].row]};
    const std::uint64_t component = l.sorting[k].component;
    for (; here.count < 8 && k < l.sorting.size() && l.sorting[k].component == component; here.count++, k++) {
      const Vec3d x = f.position[l.sorting[k].row];
      Vec3d low = here.low, high = here.high;
      bool far = false;
      for (int a = 0; a < 3; a++) {
        low[a] = std::min(low[a], x[a]);
        high[a] = std::max(high[a], x[a]);
        far = far || high[a] - low[a] > longest;
      }
      if (far) break;
      here.low = low;
      here.high = high;
      at[here.count] = x;
      l.self.push_back(l.sorting[k].row);
    }
    for (int n = here.count; n < 8; n++) l.self.push_back(l.self[8 * l.lanes.size()]);
    l.lanes.push_back(static_cast<std::uint8_t>(here.count));
    here.find(surfelBins, f.component.data(), component, radii.surfels, l.surfel);
    here.find(particleBins, s.particles.component.data(), component, radii.particles, l.particle);
    l.firstSurfel.push_back(l.surfel.size());
    l.firstParticle.push_back(l.particle.size());
  }
}

}  // namespace thaw
