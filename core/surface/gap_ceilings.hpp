// Sheets of one component that face each other across a gap: what a surfel must not take for its own body
// (docs/validation/stability.md B20, B22).
#pragma once
#include <cstdint>
#include <vector>

#include "core/surface/bins.hpp"
#include "core/surface/group_lists.hpp"
#include "core/surface/surface.hpp"

namespace thaw {

/// Surfels::ceiling of the owned surfels with `free`: that of the lowest surfel right over it that looks back
/// at it (near_sheets.hpp), infinity where there is none within `reach` (m). again: only of those that have
/// one, since sheets close in from afar slowly. Needs bins of the surfels, ghosts included.
void findCeilings(Surface& surface, const std::vector<std::uint8_t>& free, const Bins& bins, double reach,
                  bool again);

/// For the force sums, in support radii of the grid; and of each group whether any of its surfels has one.
struct GapCeilings {
  bool any = false;
  std::vector<float> height;
  std::vector<std::uint8_t> ofGroup;
};
void packCeilings(const Surface& surface, const GroupLists& lists, GapCeilings& ceilings);

}  // namespace thaw
