// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "core/walls/wall_forces.hpp"

namespace thaw {

/// Subtracts the area that walls cover from Continuum::exposedArea.
void coverAreas(const WallView& world, const WallContacts& contacts);

}  // namespace thaw
