// SPDX-License-Identifier: Apache-2.0
#include "core/oriented/adaptive_sampling/blocked_sites.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/neighbours/rows_around.hpp"
#include "core/oriented/laws/solid_fraction.hpp"

namespace thaw {
namespace {

// Kernel fraction of a solid that blocks a site. It is reached 0.1 spacings above a flat surface, and less
// than 0.33 spacings below an edge.
// Contact keeps particles at 0.1 spacings, and fine surfaces at up to 0.33.
constexpr double below = 0.4;
constexpr double unit = 1.0 / (1 << 30);  // integer unit of the sums, so the sums do not depend on the order

bool inObstacle(const Walls& walls, const Scene& scene, const BirthSite& b) {
  const double reach = std::max(b.apart, 1e-3 * scene.spacing);
  return std::any_of(walls.list.begin(), walls.list.end(), [&](const Wall& wall) {
    if (!wall.present) return false;
    const Vec3d rest = toRest(wall.pose, b.place);
    return nearBounds(wall.bounds, rest, reach) && wall.shape->distanceWithin(rest, reach) < b.apart;
  });
}

/// Returns the sites of all ranks in rank order; `mine` is the index of this rank's first one.
std::vector<Vec3d> gather(const std::vector<BirthSite>& places, Reducer& all, std::size_t& mine) {
  std::vector<std::int64_t> counts(static_cast<std::size_t>(all.size()), 0);
  counts[static_cast<std::size_t>(all.rank())] = static_cast<std::int64_t>(places.size());
  all.sum(counts);
  mine = 0;
  std::size_t total = 0;
  for (std::size_t r = 0; r < counts.size(); r++) {
    if (r == static_cast<std::size_t>(all.rank())) mine = total;
    total += static_cast<std::size_t>(counts[r]);
  }
  std::vector<std::int64_t> words(3 * total, 0);
  for (std::size_t k = 0; k < places.size(); k++)
    for (int a = 0; a < 3; a++)
      words[3 * (mine + k) + static_cast<std::size_t>(a)] = std::bit_cast<std::int64_t>(places[k].place[a]);
  if (total > 0) all.sum(words);
  std::vector<Vec3d> gathered(total);
  for (std::size_t k = 0; k < total; k++)
    for (int a = 0; a < 3; a++)
      gathered[k][a] = std::bit_cast<double>(words[3 * k + static_cast<std::size_t>(a)]);
  return gathered;
}

/// Calls use(image) for a position and its periodic images within `reach` of the domain.
template<class Use>
void eachImage(const CellGrid& g, const Domain& d, const Vec3d& x, double reach, Use&& use) {
  int low[3]{}, high[3]{};
  for (int a = 0; a < 3; a++)
    if (g.periodic[a]) low[a] = x[a] > d.max[a] - reach ? -1 : 0, high[a] = x[a] < d.min[a] + reach ? 1 : 0;
  for (int k = low[2]; k <= high[2]; k++)
    for (int j = low[1]; j <= high[1]; j++)
      for (int i = low[0]; i <= high[0]; i++) use(x + Vec3d{i * g.period.x, j * g.period.y, k * g.period.z});
}

/// Adds the kernel fractions that this rank's particles of each solid body fill at a position (m), in integer
/// units.
void addSolidFractions(const OrientedView& w, const Vec3d& place, std::int64_t* shares) {
  const Continuum& p = w.particles;
  const double s = w.scene.spacing;
  std::vector<RowSpan> ranges;
  eachImage(w.grid, w.scene.domain, place, 2 * s, [&](const Vec3d& x) {
    rowsAround(w.cells, cellKey(cellOf(w.grid, x)), ranges);
    for (const RowSpan& r : ranges)
      for (std::uint32_t j = r.begin; j < std::min(r.end, static_cast<std::uint32_t>(p.owned)); j++)
        if (p.phase[j] == Solid && p.body[j] < w.scene.bodies.size())
          shares[p.body[j]] += std::llround(solidFraction(length(p.position[j] - x), s) / unit);
  });
}

}  // namespace

std::vector<char> blockedSites(const OrientedView& w, const std::vector<BirthSite>& places, Reducer& all) {
  std::vector<char> taken(places.size());
  for (std::size_t k = 0; k < places.size(); k++) taken[k] = inObstacle(w.walls, w.scene, places[k]);
  if (!w.modules.orientedContact || !w.modules.solid || w.scene.bodies.empty()) return taken;
  std::size_t mine = 0;
  const std::vector<Vec3d> everywhere = gather(places, all, mine);
  if (everywhere.empty()) return taken;
  const std::size_t bodies = w.scene.bodies.size();
  std::vector<std::int64_t> shares(everywhere.size() * bodies, 0);
  for (std::size_t k = 0; k < everywhere.size(); k++)
    addSolidFractions(w, everywhere[k], shares.data() + k * bodies);
  all.sum(shares);
  for (std::size_t k = 0; k < places.size(); k++)
    for (std::size_t b = 0; b < bodies; b++)
      if (static_cast<double>(shares[(mine + k) * bodies + b]) * unit > below) taken[k] = 1;
  return taken;
}

}  // namespace thaw
