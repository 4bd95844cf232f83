// SPDX-License-Identifier: Apache-2.0
#include "core/surface/search/inside.hpp"

#include <limits>
#include <tuple>

namespace thaw {
namespace {

constexpr double discShare = 0.5;
constexpr int mostDiscs = 12;

struct DiscView {
  double height;  // m, above the disc's plane
  double d2;      // m^2, to the closest point of the disc
};

DiscView viewOf(const Surfels& f, std::uint32_t j, const Vec3d& x) {
  const Vec3d d = x - f.position[j];
  const double height = dot(d, f.normal[j]);
  const double over = std::max(
      0.0, std::sqrt(std::max(0.0, dot(d, d) - height * height)) - discShare * f.radius[j]);
  return {height, height * height + over * over};
}

SurfaceSide sideOf(const Surfels& f, const InsideTools::Candidate* begin, const InsideTools::Candidate* end,
                   const Vec3d& x) {
  SurfaceSide side;
  side.component = begin->component;
  side.nearest = begin->row;
  const double far = begin->distance + f.radius[begin->row];
  const double least = 1e-6 * f.radius[begin->row] * f.radius[begin->row];
  double sum = 0, straight = 0;
  for (const InsideTools::Candidate* c = begin; c != end && side.discsUsed < mostDiscs && c->distance <= far;
       c++) {
    const DiscView v = viewOf(f, c->row, x);
    const double weight = 1 / (v.d2 + least);
    sum += weight * v.height;
    straight = std::max(straight, -v.height / std::sqrt(v.d2 + least));
    side.normal += weight * f.normal[c->row];
    if (f.liquid.active) side.liquid += static_cast<double>(f.liquid[c->row]);
    side.discsUsed++;
  }
  side.liquid /= side.discsUsed;
  side.normal = normalized(side.normal);
  // A disc that is only seen edge-on is the rim of an opening.
  side.distance = sum < 0 && straight > 0.5 ? -begin->distance : begin->distance;
  return side;
}

}  // namespace

void findSides(const Surfels& f, const Bins& bins, const SideQuery& query, InsideTools& t,
               std::vector<SurfaceSide>& sides) {
  const Vec3d& x = query.position;
  t.near.clear();
  sides.clear();
  t.seen.clear();
  t.groups.clear();
  double largest = 0;
  std::uint32_t group = 0;
  forRowsWithin(bins, x, query.reach, [&](std::uint32_t j, double d2) {
    const std::uint64_t c = f.component[j];
    if ((c != query.component) != query.others) return;
    if (t.groups.empty() || t.groups[group].component != c) {
      for (group = 0; group < t.groups.size() && t.groups[group].component != c;) group++;
      if (group == t.groups.size()) t.groups.push_back({c, d2});
    }
    t.groups[group].d2 = std::min(t.groups[group].d2, d2);
    largest = std::max(largest, f.radius[j]);
    t.seen.push_back({j, group, d2});
  });
  if (t.seen.empty()) return;
  // sideOf uses discs at most one radius farther than the nearest disc. The nearest disc is not farther than
  // the nearest centre. A disc extends by discShare of its radius.
  for (InsideTools::Group& g : t.groups) {
    const double far = (1 + 1e-9) * (std::sqrt(g.d2) + (1 + discShare) * largest);
    g.d2 = far * far;
  }
  for (const InsideTools::VisibleSurfel& n : t.seen)
    if (n.d2 <= t.groups[n.group].d2)
      t.near.push_back({t.groups[n.group].component, std::sqrt(viewOf(f, n.row, x).d2), f.id[n.row], n.row});
  for (InsideTools::Group& g : t.groups) g.d2 = std::numeric_limits<double>::infinity();
  std::size_t kept = 0;
  for (const InsideTools::Candidate& c : t.near)
    for (InsideTools::Group& g : t.groups)
      if (g.component == c.component) g.d2 = std::min(g.d2, c.distance);
  for (const InsideTools::Candidate& c : t.near)
    for (const InsideTools::Group& g : t.groups)
      if (g.component == c.component && c.distance <= g.d2 + largest) t.near[kept++] = c;
  t.near.resize(kept);
  std::sort(t.near.begin(), t.near.end(),
            [](const InsideTools::Candidate& a, const InsideTools::Candidate& b) {
              return std::tie(a.component, a.distance, a.id) < std::tie(b.component, b.distance, b.id);
            });
  for (std::size_t k = 0, next = 0; k < t.near.size(); k = next) {
    while (next < t.near.size() && t.near[next].component == t.near[k].component) next++;
    sides.push_back(sideOf(f, &t.near[k], &t.near[0] + next, x));
  }
}

}  // namespace thaw
