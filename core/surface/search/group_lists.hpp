// SPDX-License-Identifier: Apache-2.0
// Groups of eight adjacent surfels with their neighbour lists, for the iterations.
#pragma once
#include <cstdint>
#include <vector>

#include "core/surface/data/surface.hpp"
#include "core/surface/search/bins.hpp"

namespace thaw {

/// Neighbour lists of groups of surfels. A list is in the order of bins. It contains the surfels and
/// particles of the component within the radius plus a margin of any surfel of the group, including that
/// surfel. Lists are valid for many iterations, until a surfel has moved by half the margin. They are exact,
/// unlike K05's neighbours of neighbours, and an iteration only reads them (benchmarks/surface).
struct GroupLists {
  std::vector<std::uint32_t> self;  ///< 8 rows per group; short groups repeat their first row
  std::vector<std::uint8_t> lanes;  ///< number of rows of each group
  std::vector<std::uint64_t> firstSurfel, firstParticle;  ///< start of each group's list, and the end of the
                                                          ///< last
  std::vector<std::uint32_t> surfel, particle;
  SortedRows sorting, sorted;  ///< rows with their keys along a space-filling curve
  std::size_t groups() const { return lanes.size(); }
};

/// Search radii (m), with margins; 0: no lists.
struct ListRadii {
  double surfels, particles;
};

/// Groups the owned rows with free[row] != 0 and lists their neighbours. Requires: bins of surfels and
/// particles, ghosts included.
void listGroups(const Surface& surface, const std::vector<std::uint8_t>& free, const Bins& surfelBins,
                const Bins& particleBins, const ListRadii& radii, GroupLists& lists);

}  // namespace thaw
