// SPDX-License-Identifier: Apache-2.0
// Welding: touching rigid pieces of one material join where both surfaces are hot.
#pragma once
#include "core/halo/halos.hpp"
#include "core/rigid/rigid_view.hpp"

namespace thaw {

/// Measures Continuum::touchTime over the last step, and joins pieces. Two surface particles weld if
///   - they belong to different pieces of one material,
///   - both are hotter than Material::weldTemperature,
///   - their surfaces touch, and each has touched such a surface for Material::weldTime without
///     interruption,
///   - neither lies on a fracture that has stayed hot since the piece broke.
/// Joined pieces keep the momentum and angular momentum of their parts. The ledger records the kinetic energy
/// lost by joining. Requires: ghosts of the last evaluation, and rows of the pieces of owned particles and
/// ghosts. Ensures: the same rows. Collective.
void weldPieces(const RigidView& view, const Halos& halos);

}  // namespace thaw
