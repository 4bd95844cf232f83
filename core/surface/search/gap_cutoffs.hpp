// SPDX-License-Identifier: Apache-2.0
// Gap cutoffs between sheets of one component that face each other (docs/validation/stability.md, rows 20 and
// 22). Particles beyond a gap do not belong to the body below a surfel.
#pragma once
#include <cstdint>
#include <vector>

#include "core/surface/data/surface.hpp"
#include "core/surface/search/bins.hpp"
#include "core/surface/search/group_lists.hpp"

namespace thaw {

/// Finds Surfels::gapCutoff of owned surfels in `free`: the height of the lowest facing surfel directly above
/// (near_sheets.hpp), or infinity without one within `reach` (m). With `again`, only surfels with a finite
/// value are updated, because sheets approach slowly. Requires: bins of surfels and ghosts.
void findGapCutoffs(Surface& surface, const std::vector<std::uint8_t>& free, const Bins& bins, double reach,
                    bool again);

/// Gap cutoffs for the force sums, in support radii of the grid, and a flag for each group with a finite one.
struct GapCutoffs {
  bool any = false;
  std::vector<float> height;
  std::vector<std::uint8_t> ofGroup;
};
void packGapCutoffs(const Surface& surface, const GroupLists& lists, GapCutoffs& gapCutoffs);

}  // namespace thaw
