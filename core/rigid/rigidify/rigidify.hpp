// SPDX-License-Identifier: Apache-2.0
// Rigid pieces of elastic solids.
#pragma once
#include "core/halo/halos.hpp"
#include "core/rigid/rigidify/rigidify_view.hpp"

namespace thaw {

/// Makes pieces of the particles that do not deform now (isToBeRigid), connected by bonds, and makes all
/// others elastic. A new piece takes over the momentum and angular momentum of its particles; the kinetic
/// energy that is lost is recorded as dissipated. Clusters of fewer than `leastInPiece` particles stay
/// elastic. Requires: ghosts of the last evaluation. Collective.
void rigidifySolids(const RigidifyView& view, const Halos& halos);

/// Smallest number of particles of a piece of an elastic solid; smaller ones save no time.
inline constexpr std::int64_t leastInPiece = 64;

}  // namespace thaw
