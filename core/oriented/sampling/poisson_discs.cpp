// SPDX-License-Identifier: Apache-2.0
#include "core/oriented/sampling/poisson_discs.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace thaw {

void addPoissonDiscs(std::vector<SurfaceSample>& samples, double apart, SampledPoints& m) {
  if (samples.empty()) return;
  std::sort(samples.begin(), samples.end(),
            [](const SurfaceSample& a, const SurfaceSample& b) { return a.rank < b.rank; });
  Vec3d low = samples[0].place;
  for (int a = 0; a < 3; a++) {
    for (const SurfaceSample& s : samples) low[a] = std::min(low[a], s.place[a]);
    for (const Vec3d& x : m.places) low[a] = std::min(low[a], x[a]);
  }
  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> bins;
  const auto binOf = [&](const Vec3d& x, int a) {
    return static_cast<std::int64_t>(std::floor((x[a] - low[a]) / apart)) + 1;
  };
  const auto key = [](std::int64_t x, std::int64_t y, std::int64_t z) {
    return static_cast<std::uint64_t>(z) << 42 | static_cast<std::uint64_t>(y) << 21 |
           static_cast<std::uint64_t>(x);
  };
  for (std::size_t q = 0; q < m.places.size(); q++)
    bins[key(binOf(m.places[q], 0), binOf(m.places[q], 1), binOf(m.places[q], 2))].push_back(
        static_cast<std::uint32_t>(q));
  for (const SurfaceSample& s : samples) {
    const std::int64_t bx = binOf(s.place, 0), by = binOf(s.place, 1), bz = binOf(s.place, 2);
    bool free = true;
    for (std::int64_t z = bz - 1; z <= bz + 1 && free; z++)
      for (std::int64_t y = by - 1; y <= by + 1 && free; y++)
        for (std::int64_t x = bx - 1; x <= bx + 1 && free; x++) {
          const auto there = bins.find(key(x, y, z));
          if (there == bins.end()) continue;
          for (const std::uint32_t q : there->second) {
            const Vec3d d = m.places[q] - s.place;
            if (dot(d, d) < apart * apart && dot(m.normals[q], s.normal) > 0) free = false;
          }
        }
    if (!free) continue;
    bins[key(bx, by, bz)].push_back(static_cast<std::uint32_t>(m.places.size()));
    addPoint(m, s.place, s.normal);
  }
}

}  // namespace thaw
