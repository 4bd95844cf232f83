// SPDX-License-Identifier: Apache-2.0
#include "core/surface/seeding/narrow_gaps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/halo/gather_words.hpp"
#include "core/surface/data/sampled_bodies.hpp"
#include "core/surface/seeding/seeds.hpp"

namespace thaw {
namespace {

// Spacings, slightly more than the distance of the farthest of 26 neighbours in a cubic lattice. A gap of one
// layer is wider.
constexpr double neighbour = 1.75;
// path length over straight distance
constexpr double detour = 1.5;
// cosine of the cone around an empty direction
constexpr double inDirection = 0.9;

/// Neighbourhood of one particle.
class NeighbourPaths {
 public:
  NeighbourPaths(const Scene& scene, const Surface& surface)
      : surface_(surface), near_(neighbour * scene.spacing) {}

  bool hasGap(std::size_t i, const Bins& bins, const SeedDirections& seeds) {
    const SurfaceParticles& p = surface_.particles;
    const double reach = surface_.particleSupport;
    at_.assign(1, Vec3d{});
    forRowsAround(bins, p.position[i], p.position[i], reach, [&](std::uint32_t j, const Vec3d& there) {
      const Vec3d d = there - p.position[i];
      if (j != i && p.component[j] == p.component[i] && dot(d, d) <= reach * reach) at_.push_back(d);
    });
    if (!anyBehindAnEmptyPlace(seeds)) return false;
    findWays();
    for (std::size_t k = 1; k < at_.size(); k++)
      if (way_[k] > detour * length(at_[k])) return true;
    return false;
  }

 private:
  const Surface& surface_;
  double near_;  // m
  FreeDirections free_;
  std::vector<Vec3d> at_;    // m, positions relative to the particle, which is the first
  std::vector<double> way_;  // m, shortest path length
  std::vector<std::uint8_t> done_;

  bool anyBehindAnEmptyPlace(const SeedDirections& seeds) {
    free_.begin(seeds);
    for (const Vec3d& d : at_)
      if (const double r2 = dot(d, d); r2 > 0 && r2 < near_ * near_) free_.take(d / std::sqrt(r2));
    for (int k = 0; k < seeds.count(); k++) {
      if (free_.taken(k)) continue;
      const Vec3d u = seeds[k];
      for (const Vec3d& d : at_)
        if (const double along = dot(d, u);
            along > near_ && along * along > inDirection * inDirection * dot(d, d))
          return true;
    }
    return false;
  }

  /// Finds shortest paths with Dijkstra's algorithm.
  void findWays() {
    constexpr double none = std::numeric_limits<double>::infinity();
    const std::size_t n = at_.size();
    way_.assign(n, none);
    done_.assign(n, 0);
    way_[0] = 0;
    for (;;) {
      std::size_t k = n;
      for (std::size_t m = 0; m < n; m++)
        if (!done_[m] && way_[m] < none && (k == n || way_[m] < way_[k])) k = m;
      if (k == n) return;
      done_[k] = 1;
      for (std::size_t m = 0; m < n; m++) {
        const Vec3d d = at_[m] - at_[k];
        if (const double r2 = dot(d, d); r2 <= near_ * near_)
          way_[m] = std::min(way_[m], way_[k] + std::sqrt(r2));
      }
    }
  }
};

/// Returns the labels of all ranks, ascending and unique.
std::vector<std::uint64_t> ofAll(Reducer& all, const std::vector<std::uint64_t>& mine) {
  std::vector<std::uint64_t> labels = gatherWords(all, mine);
  std::sort(labels.begin(), labels.end());
  labels.erase(std::unique(labels.begin(), labels.end()), labels.end());
  return labels;
}

}  // namespace

NarrowGaps findNarrowGaps(const Scene& scene, const Surface& surface, const Bins& bins, Reducer& all) {
  const SurfaceParticles& p = surface.particles;
  NarrowGaps mine;
  NeighbourPaths around(scene, surface);
  SeedDirections seeds(scene, surface);
  for (std::size_t i = 0; i < p.owned; i++) {
    if (isSampled(scene, p.body[i]) || p.component[i] == noComponent || p.colour[i] >= innerColour) continue;
    std::vector<std::uint64_t>& known = p.liquid.active && p.liquid[i] >= 0.5f ? mine.liquid : mine.solid;
    if (std::find(known.begin(), known.end(), p.component[i]) != known.end()) continue;
    seeds.turn(p.id[i]);
    if (around.hasGap(i, bins, seeds)) known.push_back(p.component[i]);
  }
  return {ofAll(all, mine.solid), ofAll(all, mine.liquid)};
}

}  // namespace thaw
