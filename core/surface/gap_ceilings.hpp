// Sheets of one component that face each other across a gap: what a surfel must not take for its own body (accuracy.md B20, B22).
#pragma once
#include <cstdint>
#include <vector>

#include "core/surface/bins.hpp"
#include "core/surface/group_lists.hpp"
#include "core/surface/surface.hpp"

namespace thaw {

/// Height (m) over each owned surfel's plane from which on particles belong to a sheet across a gap (near_sheets.hpp), that of the
/// lowest surfel right over it that looks back at it; infinity where there is none within `reach` (m) or `free` is 0. And of each group whether any of
/// its surfels has one. Needs bins of the surfels, ghosts included. Returns the number of surfels with a ceiling.
struct GapCeilings {
  std::vector<float> height;
  std::vector<std::uint8_t> ofGroup;
};
std::size_t findCeilings(const Surface& surface, const std::vector<std::uint8_t>& free, const Bins& bins, double reach, const GroupLists& lists, GapCeilings& ceilings);

}  // namespace thaw
