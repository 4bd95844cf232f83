// SPDX-License-Identifier: Apache-2.0
// Distance from a wall at which an elastic solid rests.
#pragma once
#include "core/particles/bonds.hpp"
#include "core/walls/wall_forces.hpp"

namespace thaw {

/// Returns true if the surface of a solid moves with its particles: it neither flows nor melts. Only such
/// solids have wall offsets and friction springs. On friction springs, pastes would slump too little, and
/// melting surfaces would gain energy.
inline bool keepsSurface(const Material& m) { return !m.yields() && !m.melts(); }

/// Sets Continuum::wallOffset of particles close to walls: half a spacing, or Continuum::contactDepth where
/// the surface of the body faces the wall. The direction of the surface is that of sum w (x_i - x_j) over the
/// particle's bonds. Materials that yield or melt keep half a spacing (keepsSurface).
/// Requires: Solids::position of all bonds.
/// Ensures: an offset stays while the contact lasts, so that it does no work.
void findWallOffsets(const WallView& world, const WallContacts& contacts, const Bonds& bonds);

}  // namespace thaw
