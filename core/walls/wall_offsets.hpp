// SPDX-License-Identifier: Apache-2.0
// Distance from a wall at which an elastic solid rests.
#pragma once
#include "core/particles/bonds.hpp"
#include "core/walls/wall_forces.hpp"

namespace thaw {

/// Sets Continuum::wallOffset of particles close to walls: half a spacing, or Continuum::contactDepth where
/// the surface of the body faces the wall. The direction of the surface is that of sum w (x_i - x_j) over the
/// particle's bonds. Materials that yield keep half a spacing, since plastic flow moves their surfaces.
/// Requires: Solids::position of all bonds.
/// Ensures: an offset stays while the contact lasts, so that it does no work.
void findWallOffsets(const WallContext& context, const WallContacts& contacts, const Bonds& bonds);

}  // namespace thaw
