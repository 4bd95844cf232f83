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

/// Returns the number of owned liquid particles with at least two neighbours, and the sum of their relative
/// densities in units of 1e-6. relativeDensity: summed, by row.
std::array<std::int64_t, 2> connectedSums(const Continuum& particles, const NeighbourLists& lists,
                                          std::span<const float> relativeDensity);

/// Mean summed relative density (1) of the liquid particles that have at least two neighbours; 1 where there
/// are none. With carried densities, the value is at most 16 steps old. The outermost layer of a flat surface
/// has 0.87, a single layer 0.74. The result is the same on any number of ranks. Collective.
double connectedDensity(const Modules& modules, const Continuum& particles, const NeighbourLists& lists,
                        const Counters& counters, Reducer& all);

}  // namespace thaw
