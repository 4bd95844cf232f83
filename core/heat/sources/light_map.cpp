// SPDX-License-Identifier: Apache-2.0
#include "core/heat/sources/light_map.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace thaw {
namespace {

// In spacings.
constexpr double meetReach = 0.75;    ///< larger than the distance of a lattice cell's corner, 0.71
constexpr double outline = 0.583;     ///< discs of this radius around a row of particles reach half a spacing
                                      ///< beyond the row on average
constexpr double deepestWeight = 28;  ///< absorption depths after which integer weights are 0
constexpr double layer = 0.75;  ///< particles count as exposed up to this depth: less than a lattice layer

/// Returns the distance (m) up to which a ray hits a particle. Wider cells need a larger distance.
double meetReachOf(const LightView& v, double depth, double spacing) {
  return std::max(meetReach * spacing, 0.75 * cellWidth(v, depth));
}

/// Returns true if a neighbour of a cell has no particle: the outline passes nearby.
bool atOutline(const LightMap& map, const LightView& v, std::size_t cell) {
  const auto width = v.count[0];
  const auto i = static_cast<std::int64_t>(cell) % width, j = static_cast<std::int64_t>(cell) / width;
  for (std::int64_t dj = -1; dj <= 1; dj++)
    for (std::int64_t di = -1; di <= 1; di++) {
      if (i + di < 0 || i + di >= width || j + dj < 0 || j + dj >= v.count[1]) continue;
      if (!map.met(v.first + static_cast<std::size_t>((j + dj) * width + i + di))) return true;
    }
  return false;
}

/// Depths of the rays near a group. all: every ray hits a particle.
struct GroupDepths {
  bool all = true;
  double deepest = -never;  ///< m, largest depth of the rays that hit a particle
};

GroupDepths depthsNear(const LightMap& map, const LightView& v, const CellRange& range) {
  GroupDepths d;
  for (std::int64_t j = range.low[1]; j < range.high[1]; j++) {
    const std::size_t row = v.first + static_cast<std::size_t>((j - v.low[1]) * v.count[0]);
    for (std::int64_t i = range.low[0]; i < range.high[0]; i++) {
      const double depth = map.depth(row + static_cast<std::size_t>(i - v.low[0]));
      if (depth == never) d.all = false;
      else d.deepest = std::max(d.deepest, depth);
    }
    if (!d.all) break;
  }
  return d;
}

/// Returns true if each ray either hits a particle nearer than this depth (m) or hits none.
bool isHidden(const LightMap& map, const LightView& v, const CellRange& range, double depth) {
  for (std::int64_t j = range.low[1]; j < range.high[1]; j++) {
    const std::size_t row = v.first + static_cast<std::size_t>((j - v.low[1]) * v.count[0]);
    for (std::int64_t i = range.low[0]; i < range.high[0]; i++) {
      const double met = map.depth(row + static_cast<std::size_t>(i - v.low[0]));
      if (met >= depth && met < never) return false;
    }
  }
  return true;
}

/// Adds a particle's weights for the rays of view k. Returns true if one of them lights it.
bool addWeights(const Vec3d& x, std::size_t k, double spacing, LightWork& w) {
  const LightView& v = w.views[k];
  const LightSource& source = w.sources[v.source];
  const Sight s = sightOf(v, x);
  const double reach = shareReach(v, s.depth, spacing), scale = 1 / (reach * reach);
  bool lit = false;
  eachRayNear(v, s, reach, [&](std::size_t c, double d2) {
    const std::size_t cell = v.first + c;
    if (!w.map.met(cell)) return;
    const std::int64_t weight = lightWeight(source, s.depth - w.map.depth(cell), d2 * scale, spacing);
    w.map.weights[cell] += weight;
    lit = lit || weight > 0;
  });
  return lit;
}

/// Orders the groups by their distance along the light, in 256 steps.
void orderGroups(const LightView& v, LightWork& w) {
  constexpr std::size_t steps = 256;
  std::vector<float> distance(w.groups.size());
  float low = std::numeric_limits<float>::max(), high = -low;
  for (std::size_t g = 0; g < w.groups.size(); g++) {
    distance[g] = static_cast<float>(sightOf(v, w.groups[g].centre).depth);
    low = std::min(low, distance[g]);
    high = std::max(high, distance[g]);
  }
  const float scale = high > low ? (steps - 1) / (high - low) : 0;
  std::array<std::uint32_t, steps + 1> first{};
  const auto stepOf = [&](std::size_t g) { return static_cast<std::size_t>((distance[g] - low) * scale); };
  for (std::size_t g = 0; g < w.groups.size(); g++) first[stepOf(g) + 1]++;
  for (std::size_t k = 0; k < steps; k++) first[k + 1] += first[k];
  w.order.resize(w.groups.size());
  for (std::size_t g = 0; g < w.groups.size(); g++)
    w.order[first[stepOf(g)]++] = static_cast<std::uint32_t>(g);
}

}  // namespace

void groupRows(const Continuum& p, LightWork& w) {
  w.groups.clear();
  for (std::size_t begin = 0, end = 0; begin < p.owned; begin = end) {
    Vec3d low = p.position[begin], high = low;
    for (end = begin; end < p.owned && p.cell[end] == p.cell[begin]; end++)
      for (int a = 0; a < 3; a++) {
        low[a] = std::min(low[a], p.position[end][a]);
        high[a] = std::max(high[a], p.position[end][a]);
      }
    w.groups.push_back({static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end),
                        (low + high) * 0.5, 0.5 * length(high - low)});
  }
}

void findDepths(const Continuum& p, double spacing, LightWork& w, Reducer& all) {
  const std::size_t cells = w.views.empty() ? 0 : w.views.back().first + w.views.back().cells();
  w.map.weights.assign(cells, 0);
  w.map.covered.assign(cells, -1);
  w.map.values.assign(2 * cells, -never);
  for (const LightView& v : w.views) {
    double *const nearest = w.map.values.data() + v.first, *const gap = nearest + cells;
    orderGroups(v, w);
    for (const std::uint32_t g : w.order) {
      const LightGroup& group = w.groups[g];
      const Sight centre = sightOf(v, group.centre);
      const double near = centre.depth - group.radius, width = cellWidth(v, centre.depth + group.radius);
      const CellRange range = cellsNear(v, centre, group.radius + std::max(spacing, width) + 1.5 * width);
      if (range.empty()) continue;
      // A group behind all particles that the rays here hit changes neither depth nor outline.
      if (const GroupDepths d = depthsNear(w.map, v, range); d.all && d.deepest <= near) continue;
      for (std::size_t i = group.begin; i < group.end; i++) {
        const Sight s = sightOf(v, p.position[i]);
        eachRayNear(v, s, meetReachOf(v, s.depth, spacing), [&](std::size_t c, double d2) {
          nearest[c] = std::max(nearest[c], -s.depth);
          gap[c] = std::max(gap[c], -d2);
        });
      }
    }
  }
  all.maximum(w.map.values);
}

void findWeights(const Continuum& p, double spacing, LightWork& w, Reducer& all) {
  w.lit.clear();
  for (std::size_t k = 0; k < w.views.size(); k++) {
    const LightView& v = w.views[k];
    const LightSource& source = w.sources[v.source];
    const double behind = source.depth > 0 ? deepestWeight * source.depth : layer * spacing;
    for (const LightGroup& group : w.groups) {
      const Sight centre = sightOf(v, group.centre);
      const double near = centre.depth - group.radius, width = cellWidth(v, centre.depth + group.radius);
      const CellRange range = cellsNear(v, centre, group.radius + std::max(spacing, width));
      if (range.empty() || isHidden(w.map, v, range, near - behind)) continue;
      for (std::size_t i = group.begin; i < group.end; i++)
        if (addWeights(p.position[i], k, spacing, w))
          w.lit.push_back({static_cast<std::uint32_t>(k), static_cast<std::uint32_t>(i)});
    }
  }
  all.sum(w.map.weights);
}

double coverageOf(LightMap& map, const LightView& v, std::size_t cell, double spacing) {
  float& covered = map.covered[v.first + cell];
  if (covered >= 0) return static_cast<double>(covered);
  covered = 1;
  if (atOutline(map, v, cell)) {
    const double width = cellWidth(v, map.depth(v.first + cell)), gap = std::sqrt(map.gap2(v.first + cell));
    covered = static_cast<float>(std::clamp((outline * spacing + 0.5 * width - gap) / width, 0.0, 1.0));
  }
  return static_cast<double>(covered);
}

double shareReach(const LightView& v, double depth, double spacing) {
  return 4.0 / 3 * meetReachOf(v, depth, spacing);
}

std::int64_t lightWeight(const LightSource& s, double behind, double fraction2, double spacing) {
  if (s.depth == 0 && behind > layer * spacing) return 0;
  const double near = 1 - fraction2;
  // Sums of 2^20 particles fit into 63 bits.
  const double weight = 0x1p40 * near * near * (s.depth > 0 ? std::exp(-std::max(behind, 0.0) / s.depth) : 1);
  return static_cast<std::int64_t>(weight);
}

}  // namespace thaw
