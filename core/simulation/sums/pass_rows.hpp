// SPDX-License-Identifier: Apache-2.0
// Rows of a pass of sums over neighbours.
#pragma once
#include <cstddef>

#include "core/fluid/pair_sums/pair_sums.hpp"
#include "core/neighbours/neighbour_lists.hpp"
#include "core/neighbours/search.hpp"

namespace thaw {

/// The inner pass covers rows whose neighbours are all owned, while ghosts are exchanged. The boundary pass
/// covers the other rows.
struct PassRows {
  Part part = Part::Inner;
  GroupRange groups{0, 0};         ///< groups of neighbour lists whose sums are computed
  std::size_t begin = 0, end = 0;  ///< rows whose records are packed: owned rows in the inner pass, ghosts in
                                   ///< the boundary pass
};

/// Returns the rows of a pass. Requires: searched lists.
inline PassRows passRows(Part part, const NeighbourLists& lists, std::size_t owned, std::size_t all) {
  if (part == Part::Inner) return {part, {0, lists.innerGroups}, 0, owned};
  return {part, {lists.innerGroups, lists.groups}, owned, all};
}

}  // namespace thaw
