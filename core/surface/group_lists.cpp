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

struct Box {
  Vec3d low, high;
  void add(const Vec3d& x) {
    for (int a = 0; a < 3; a++) low[a] = std::min(low[a], x[a]), high[a] = std::max(high[a], x[a]);
  }
  double longest() const { return std::max({high.x - low.x, high.y - low.y, high.z - low.z}); }
  double distance2(const Vec3d& x) const {
    const Vec3d d{std::max({low.x - x.x, 0.0, x.x - high.x}), std::max({low.y - x.y, 0.0, x.y - high.y}), std::max({low.z - x.z, 0.0, x.z - high.z})};
    return dot(d, d);
  }
};

/// Rows of one component around a block of groups, looked up once for all of them.
struct Around {
  std::vector<std::uint32_t> row;
  std::vector<Vec3d> at;
  void find(const Bins& bins, const std::uint64_t* component, std::uint64_t wanted, const Box& box, double radius) {
    const double r2 = radius * radius;
    row.clear();
    at.clear();
    forRowsAround(bins, box.low, box.high, radius, [&](std::uint32_t j, const Vec3d& x) {
      if (box.distance2(x) < r2 && component[j] == wanted) row.push_back(j), at.push_back(x);
    });
  }
  /// Those within `radius` of a group's box. What is farther from all of its surfels than that adds nothing to their sums.
  void append(const Box& box, double radius, std::vector<std::uint32_t>& rows) const {
    const double r2 = radius * radius;
    std::size_t n = rows.size();
    rows.resize(n + row.size());
    for (std::size_t k = 0; k < row.size(); k++) {
      rows[n] = row[k];
      n += box.distance2(at[k]) < r2;
    }
    rows.resize(n);
  }
};

}  // namespace

void listGroups(const Surface& s, const std::vector<std::uint8_t>& free, const Bins& surfelBins, const Bins& particleBins, const ListRadii& radii, GroupLists& l) {
  const Surfels& f = s.surfels;
  const double curveEdge = 2.5 * s.spacing, longest = 6 * s.spacing;  // eight surfels of a smooth surface cover about a block's side
  l.sorting.clear();
  for (std::uint32_t i = 0; i < f.owned; i++) {
    if (!free[i]) continue;
    std::uint64_t curve = 0;
    for (int a = 0; a < 3; a++) curve |= spread(static_cast<std::uint64_t>(std::clamp((f.position[i][a] - surfelBins.base[a]) / curveEdge, 0.0, binsPerAxis))) << a;
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
  const auto place = [&](std::size_t k) { return f.position[l.sorting[k].row]; };
  Around surfels, particles;
  for (std::size_t k = 0; k < l.sorting.size();) {
    // a block of groups that lie together
    const std::uint64_t component = l.sorting[k].component;
    const auto boxFrom = [&](std::size_t from, std::size_t most, double side, std::size_t& to) {
      Box box{place(from), place(from)};
      for (to = from + 1; to < l.sorting.size() && to < from + most && l.sorting[to].component == component; to++) {
        Box more = box;
        more.add(place(to));
        if (more.longest() > side) break;
        box = more;
      }
      return box;
    };
    std::size_t end = k;
    const Box block = boxFrom(k, 64, 2 * longest, end);
    surfels.find(surfelBins, f.component.data(), component, block, radii.surfels);
    particles.find(particleBins, s.particles.component.data(), component, block, radii.particles);
    while (k < end) {
      std::size_t last = k;
      const Box box = boxFrom(k, std::min<std::size_t>(8, end - k), longest, last);
      for (std::size_t n = 0; n < 8; n++) l.self.push_back(l.sorting[std::min(k + n, last - 1)].row);
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
