// SPDX-License-Identifier: Apache-2.0
// Pieces after their particles melted, froze or left: connected pieces and their mass properties.
#pragma once
#include "core/halo/halos.hpp"
#include "core/rigid/rigid_view.hpp"

namespace thaw {

/// Pieces::contactLoad of the pieces of the start, until their contacts are solved.
inline constexpr double unknownLoad = -1;

/// Marks particles of rigid materials as pieces of their own, which have no bonds. Call it once, before the
/// first evaluation.
void markRigidParticles(const Scene& scene, Continuum& particles);

/// Makes the pieces of the particles as they are now. Pieces whose particles changed get new mass properties,
/// with the momentum and angular momentum of their particles. Energy that joining takes goes to the ledger,
/// but not at the start, where pieces take the mean motion of their particles. Requires: ghosts of the last
/// evaluation. Ensures: rows of the pieces of owned particles. Collective.
void updatePieces(const RigidView& view, const Halos& halos, bool atStart);

/// As updatePieces, with the pieces that Continuum::setLabel gives for owned particles.
void remakePieces(const RigidView& view, const Halos& halos, bool atStart);

}  // namespace thaw
