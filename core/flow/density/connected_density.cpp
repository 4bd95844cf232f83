// SPDX-License-Identifier: Apache-2.0
#include "core/flow/density/connected_density.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/fluid/laws/particle_pressure.hpp"

namespace thaw {
namespace {

constexpr double unit = 1e-6;  // integers, whose sum does not depend on the order

}  // namespace

std::array<std::int64_t, 2> connectedSums(const Continuum& p, const NeighbourLists& lists,
                                          std::span<const float> relativeDensity) {
  constexpr std::uint16_t connected = 2;
  std::array<std::int64_t, 2> sums{};
  for (std::size_t i = 0; i < p.owned && i < lists.neighbours.size(); i++) {
    if (liquidFraction(p, i) < 1 || lists.neighbours[i] < connected) continue;
    sums[0]++;
    sums[1] += std::llround(std::min(static_cast<double>(relativeDensity[i]), 1e6) / unit);
  }
  return sums;
}

double connectedDensity(const Modules& modules, const Continuum& p, const NeighbourLists& lists,
                        const Counters& counters, Reducer& all) {
  if (!modules.fluid) return 1;
  std::array<std::int64_t, 2> sums{counters.connected, counters.connectedDensity};
  if (!modules.continuity) sums = connectedSums(p, lists, {p.relativeDensity.data(), p.owned});
  all.sum(sums);
  return sums[0] > 0 ? unit * static_cast<double>(sums[1]) / static_cast<double>(sums[0]) : 1;
}

}  // namespace thaw
