// SPDX-License-Identifier: Apache-2.0
#include "core/fluid/density/connected_density.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/fluid/laws/particle_pressure.hpp"

namespace thaw {
namespace {

constexpr double unit = 1e-6;  // integers, whose sum does not depend on the order

}  // namespace

std::array<std::int64_t, 2> connectedSums(const World& w, std::span<const float> relativeDensity) {
  constexpr std::uint16_t connected = 2;
  const Continuum& p = w.particles;
  std::array<std::int64_t, 2> sums{};
  for (std::size_t i = 0; i < p.owned && i < w.neighbours.neighbours.size(); i++) {
    if (liquidFraction(p, i) < 1 || w.neighbours.neighbours[i] < connected) continue;
    sums[0]++;
    sums[1] += std::llround(std::min(static_cast<double>(relativeDensity[i]), 1e6) / unit);
  }
  return sums;
}

double connectedDensity(const World& w, Reducer& all) {
  if (!w.modules.fluid) return 1;
  std::array<std::int64_t, 2> sums{w.counters.connected, w.counters.connectedDensity};
  if (!w.modules.continuity) sums = connectedSums(w, {w.particles.relativeDensity.data(), w.particles.owned});
  all.sum(sums);
  return sums[0] > 0 ? unit * static_cast<double>(sums[1]) / static_cast<double>(sums[0]) : 1;
}

}  // namespace thaw
