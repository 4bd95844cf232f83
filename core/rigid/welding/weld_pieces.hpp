// SPDX-License-Identifier: Apache-2.0
// Welding: rigid pieces of one material that touch join where both surfaces are hot.
#pragma once
#include "core/halo/halos.hpp"
#include "core/rigid/rigid_view.hpp"

namespace thaw {

/// Measures Continuum::touchTime over the last step, and joins pieces. Two surface particles weld if
///   - they belong to different pieces of one material,
///   - both are hotter than Material::weldTemperature,
///   - their surfaces touch, and each has touched such a surface for Material::weldTime without a break,
///   - neither is at a fracture that has been hot since the piece broke.
/// Joined pieces keep the momentum and angular momentum of their parts. The kinetic energy that joining takes
/// goes to the ledger. Requires: ghosts of the last evaluation, and rows of the pieces of owned particles and
/// ghosts. Ensures: the same rows. Collective.
void weldPieces(const RigidView& view, const Halos& halos);

}  // namespace thaw
