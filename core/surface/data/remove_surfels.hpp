// SPDX-License-Identifier: Apache-2.0
// Removal of surfels.
#pragma once
#include <cstdint>
#include <span>

#include "core/surface/data/surface.hpp"

namespace thaw {

/// Removes the owned surfels with dead[row] != 0, and all ghosts. The others keep their order, and
/// `surfelCells` lists their cells. Returns the number of removed surfels. Not collective.
std::int64_t removeSurfels(Surface& surface, std::span<const std::uint8_t> dead);

}  // namespace thaw
