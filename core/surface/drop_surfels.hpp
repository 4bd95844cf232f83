// Surfels that go.
#pragma once
#include <cstdint>
#include <span>

#include "core/surface/surface.hpp"

namespace thaw {

/// Removes the owned surfels with dead[row] != 0, and all ghosts; the others stay in order, `surfelCells`
/// lists their cells. Returns how many went. Not collective.
std::int64_t dropSurfels(Surface& surface, std::span<const std::uint8_t> dead);

}  // namespace thaw
