// SPDX-License-Identifier: Apache-2.0
#include "core/heat/sources/add_light.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/heat/sources/light_ends.hpp"
#include "core/heat/sources/light_map.hpp"
#include "core/heat/sources/light_sources.hpp"

namespace thaw {
namespace {

/// Returns the bounds of the particles of all ranks. Without particles, min exceeds max.
Bounds boundsOfAll(const Continuum& p, Reducer& all) {
  std::array<double, 6> extent;
  extent.fill(-never);
  for (std::size_t i = 0; i < p.owned; i++)
    for (std::size_t a = 0; a < 3; a++) {
      double &below = extent[a], &above = extent[a + 3];
      const double x = p.position[i][static_cast<int>(a)];
      below = std::max(below, -x);
      above = std::max(above, x);
    }
  all.maximum(extent);
  return {{-extent[0], -extent[1], -extent[2]}, {extent[3], extent[4], extent[5]}};
}

/// Returns true if no obstacle has moved, appeared or vanished since the last call. Records the obstacles'
/// poses.
bool obstaclesStayed(const Walls& walls, LightWork& work) {
  bool same = work.obstacles.size() == walls.list.size();
  work.obstacles.resize(walls.list.size());
  work.present.resize(walls.list.size());
  for (std::size_t k = 0; k < walls.list.size(); k++) {
    const Wall& w = walls.list[k];
    Pose& known = work.obstacles[k];
    same = same && known.move == w.pose.move && known.rotate == w.pose.rotate &&
           work.present[k] == static_cast<std::uint8_t>(w.present);
    known = w.pose;
    work.present[k] = w.present;
  }
  return same;
}

/// Returns true if the rays of two views are on the same grid and have the same powers.
bool sameRays(const CellLights& known, const LightView& v, const LightSource& s) {
  const LightView& o = known.view;
  return o.parallel == v.parallel && o.cell == v.cell && o.origin == v.origin && o.side == v.side &&
         o.up == v.up && o.ahead == v.ahead && known.source.profile == s.profile &&
         known.source.radius == s.radius && known.source.direction == s.direction;
}

/// Creates the table of a view's cells. Cells known from earlier steps keep their values.
void updateLights(CellLights& lights, const LightView& v, const LightSource& s) {
  const bool same = sameRays(lights, v, s);
  if (same && lights.view.low == v.low && lights.view.count == v.count) return;
  std::vector<CellLight> cells(v.cells());
  const LightView& o = lights.view;
  for (std::int64_t j = 0; same && j < o.count[1]; j++)
    for (std::int64_t i = 0; i < o.count[0]; i++) {
      const std::int64_t ni = i + o.low[0] - v.low[0], nj = j + o.low[1] - v.low[1];
      if (ni < 0 || nj < 0 || ni >= v.count[0] || nj >= v.count[1]) continue;
      cells[static_cast<std::size_t>(nj * v.count[0] + ni)] =
          lights.cell[static_cast<std::size_t>(j * o.count[0] + i)];
    }
  lights = {v, s, std::move(cells)};
}

/// Returns the power of a cell, and the distance at which an obstacle stops its light.
const CellLight& lightOf(CellLights& lights, std::size_t cell, const LightStops& stops) {
  CellLight& light = lights.cell[cell];
  if (light.power >= 0) return light;
  const LightView& v = lights.view;
  const auto width = v.count[0];
  const std::int64_t i = v.low[0] + static_cast<std::int64_t>(cell) % width,
                     j = v.low[1] + static_cast<std::int64_t>(cell) / width;
  light.power = std::max(0.0, powerOfCell(lights.source, v, i, j));
  light.end = light.power > 0 ? endOf(rayOf(v, i, j), v.parallel, stops) : 0;
  return light;
}

/// Returns the light (W) that a particle receives through a view.
double lightOn(const LightTarget& w, const LightStops& stops, const LitRow& lit) {
  LightWork& work = w.work;
  const LightView& v = work.views[lit.view];
  const LightSource& source = work.sources[v.source];
  const double spacing = stops.spacing;
  const Sight s = sightOf(v, w.heat.particles.position[lit.row]);
  const double reach = shareReach(v, s.depth, spacing), scale = 1 / (reach * reach);
  double sum = 0;
  eachRayNear(v, s, reach, [&](std::size_t c, double d2) {
    const std::size_t cell = v.first + c;
    if (!work.map.met(cell)) return;
    const double depth = work.map.depth(cell);
    const std::int64_t weight = lightWeight(source, s.depth - depth, d2 * scale, spacing);
    if (weight == 0) return;
    const CellLight& light = lightOf(work.lights[v.cacheIndex], c, stops);
    if (light.end < depth - 0.5 * spacing) return;
    sum += light.power * coverageOf(work.map, v, c, spacing) *
           (static_cast<double>(weight) / static_cast<double>(work.map.weights[cell]));
  });
  return source.power * sum;
}

}  // namespace

LightReceived receiveLight(const LightTarget& w, double dt, Reducer& all) {
  const Scene& s = w.heat.scene;
  const Continuum& p = w.heat.particles;
  LightWork& work = w.work;
  const double begin = w.heat.clock.time;
  work.sources = lightSources(s, begin, begin + dt, w.heat.clock.step);
  LightReceived light;
  if (work.sources.empty()) return light;
  Ledger& ledger = w.heat.ledger;
  for (const LightSource& source : work.sources) {
    const double given = givenPower(source, s.domain) * dt;
    ledger.sourceUse[source.source].given += given;
    if (all.rank() == 0) (source.laser ? ledger.lasers : ledger.lamps).given.add(given);
  }
  const Bounds bodies = boundsOfAll(p, all);
  if (bodies.min.x > bodies.max.x) return light;
  work.views.clear();
  for (std::size_t k = 0; k < work.sources.size(); k++)
    addViews(work.sources[k], k, bodies, s.spacing, work.views);
  groupRows(p, work);
  findDepths(p, s.spacing, work, all);
  findWeights(p, s.spacing, work, all);
  const bool stayed = obstaclesStayed(w.walls, work);
  if (!stayed) work.lights.clear();
  for (const LightView& v : work.views) {
    if (v.cacheIndex >= work.lights.size()) work.lights.resize(v.cacheIndex + 1);
    updateLights(work.lights[v.cacheIndex], v, work.sources[v.source]);
  }
  const LightStops stops{w.walls, {s.domain.min, s.domain.max}, s.spacing};
  light.lamps.assign(s.lamps.empty() ? 0 : p.owned, 0.0);
  light.lasers.assign(s.lasers.empty() ? 0 : p.owned, 0.0);
  for (const LitRow& lit : work.lit) {
    const LightSource& source = work.sources[work.views[lit.view].source];
    const double received = lightOn(w, stops, lit);
    (source.laser ? light.lasers : light.lamps)[lit.row] += received;
    if (received * dt > 0 && s.materials[p.material[lit.row]].absorptivity > 0)
      ledger.sourceUse[source.source].absorbed = 1;
  }
  return light;
}

}  // namespace thaw
