// Surfels in groups of eight that lie together, and what is around each group: the lists of the iterations.
#pragma once
#include <cstdint>
#include <vector>

#include "core/surface/bins.hpp"
#include "core/surface/surface.hpp"

namespace thaw {

/// Lists of a group hold the surfels and particles of its component within the radius, and a margin, of any
/// of its surfels, itself included, in the order of bins. They are found once for many iterations, as long as
/// no surfel has moved by half the margin: exact, unlike K05's neighbours of neighbours, and cheaper, since
/// an iteration only reads them (benchmarks/surface).
struct GroupLists {
  std::vector<std::uint32_t> self;  ///< 8 rows a group; a short one repeats its first row
  std::vector<std::uint8_t> lanes;  ///< rows of each group
  std::vector<std::uint64_t> firstSurfel, firstParticle;  ///< of each group, and one behind
  std::vector<std::uint32_t> surfel, particle;
  SortedRows sorting, sorted;  ///< by their places along a curve
  std::size_t groups() const { return lanes.size(); }
};

struct ListRadii {
  double surfels, particles;
};  // m, with their margins; 0: no lists of these

/// Groups of the owned rows with free[row] != 0. Needs bins of the surfels and of the particles, ghosts
/// included.
void listGroups(const Surface& surface, const std::vector<std::uint8_t>& free, const Bins& surfelBins,
                const Bins& particleBins, const ListRadii& radii, GroupLists& lists);

}  // namespace thaw
