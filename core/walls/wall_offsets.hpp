// SPDX-License-Identifier: Apache-2.0
// Distance from a wall at which an elastic solid rests.
#pragma once
#include "core/particles/bonds.hpp"
#include "core/walls/wall_forces.hpp"

namespace thaw {

/// Sets Continuum::wallOffset of the solids in contact with walls: half a spacing, or the depth of the
/// particle below the surface of its body (Continuum::contactDepth) where this surface faces the wall.
/// Staircases of a lattice, as on balls, then touch as smooth surfaces. The direction of the surface is that
/// of the sum of w (x_i - x_j) over its bonds, so it turns with the body. Materials that
/// yield keep half a spacing, since plastic flow moves surfaces. An offset stays while the contact lasts, so
/// that it does no work. Requires: Solids::position of all bonds.
void findWallOffsets(const WallContext& context, const WallContacts& contacts, const Bonds& bonds);

}  // namespace thaw
