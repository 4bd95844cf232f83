// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/monitor/interpenetration.hpp"

#include <cmath>

#include "core/halo/exchange.hpp"
#include "core/neighbours/rows_around.hpp"
#include "core/oriented/laws/solid_fraction.hpp"

namespace thaw {
namespace {

constexpr double insideFraction = 0.7;  // fraction of the kernel filled by solid
constexpr double inObstacle = 0.25;     // spacings; thin surfaces penetrate by as much as the contact spring
                                        // allows

}  // namespace

std::vector<Interpenetration> findInterpenetrations(World& w, Halos halos) {
  const std::size_t bodies = w.scene.bodies.size();
  Continuum& p = w.particles;
  const Oriented& o = w.oriented.rows;
  refresh(halos.cells, p, ColumnList{&p.phase}).wait();  // the phase may have changed since the last exchange
  const double s = w.scene.spacing;
  std::vector<std::int64_t> count(w.scene.oriented.size() * bodies, 0);
  std::vector<double> full(bodies);
  eachSurrounded(
      w.oriented.cells, o.owned, w.cells, [](std::uint32_t) { return true; },
      [&](std::uint32_t i, std::span<const RowSpan> ranges) {
        std::fill(full.begin(), full.end(), 0.0);
        for (const RowSpan& r : ranges)
          for (std::uint32_t j = r.begin; j < r.end; j++)
            if (p.phase[j] == Solid && p.body[j] < bodies)
              full[p.body[j]] += solidFraction(length(p.position[j] - o.position[i]), s);
        for (std::size_t b = 0; b < bodies; b++) count[o.body[i] * bodies + b] += full[b] > insideFraction;
      });
  halos.all.sum(count);
  std::vector<Interpenetration> found;
  for (std::size_t k = 0; k < count.size(); k++)
    if (count[k] > 0) found.push_back({k / bodies, k % bodies, count[k]});
  return found;
}

std::vector<Interpenetration> findObstacleInterpenetrations(const OrientedBodies& oriented,
                                                            const Walls& walls, const Scene& scene,
                                                            Reducer& all) {
  const Oriented& o = oriented.rows;
  const std::size_t wallCount = walls.list.size();
  std::vector<std::int64_t> count(scene.oriented.size() * wallCount, 0);
  for (std::size_t i = 0; i < o.owned; i++) {
    if (o.flags[i] & fixedPosition) continue;
    const double deep = inObstacle * spacingOf(scene, scene.oriented[o.body[i]]);
    for (std::size_t k = 0; k < wallCount; k++) {
      const Wall& wall = walls.list[k];
      if (!wall.present) continue;
      const Vec3d rest = toRest(wall.pose, o.position[i]);
      count[o.body[i] * wallCount + wall.originalAt(k)] += nearBounds(wall.bounds, rest, 0) &&
                                                           wall.shape->distanceWithin(rest, 2 * deep) < -deep;
    }
  }
  if (!count.empty()) all.sum(count);
  std::vector<Interpenetration> found;
  for (std::size_t k = 0; k < count.size(); k++)
    if (count[k] > 0) found.push_back({k / wallCount, k % wallCount, count[k]});
  return found;
}

}  // namespace thaw
