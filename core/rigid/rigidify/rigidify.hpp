// SPDX-License-Identifier: Apache-2.0
// Rigid pieces of elastic solids.
#pragma once
#include "core/halo/halos.hpp"
#include "core/rigid/rigidify/rigidify_view.hpp"

namespace thaw {

/// Makes pieces of bonded particles that do not deform (isToBeRigid), and makes all other particles elastic.
/// A new piece gets the momentum and angular momentum of its particles. The loss of kinetic energy is
/// recorded as dissipated. Clusters of fewer than `leastInPiece` particles stay elastic. Requires: ghosts of
/// the last evaluation. Collective.
void rigidifySolids(const RigidifyView& view, const Halos& halos);

/// Minimum number of particles in a piece of an elastic solid. Smaller pieces save no time.
inline constexpr std::int64_t leastInPiece = 64;

}  // namespace thaw
