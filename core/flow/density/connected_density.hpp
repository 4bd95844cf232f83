// SPDX-License-Identifier: Apache-2.0
// Mean summed density of connected liquid.
#pragma once
#include <array>
#include <cstdint>
#include <span>

#include "core/halo/halo.hpp"
#include "core/ledger/counters.hpp"
#include "core/neighbours/neighbour_lists.hpp"
#include "core/particles/continuum.hpp"
#include "core/scene/modules.hpp"

namespace thaw {

/// Number of owned liquid particles with at least two neighbours, and the sum of their summed relative
/// densities (by row) in 1e-6.
std::array<std::int64_t, 2> connectedSums(const Continuum& particles, const NeighbourLists& lists,
                                          std::span<const float> relativeDensity);

/// Mean summed relative density (1) of the liquid particles that have at least two neighbours; 1 where there
/// are none. With carried densities it is at most 16 steps old. The outermost layer of a flat surface has
/// 0.87, a single layer 0.74. The same on any number of ranks. Collective.
double connectedDensity(const Modules& modules, const Continuum& particles, const NeighbourLists& lists,
                        const Counters& counters, Reducer& all);

}  // namespace thaw
