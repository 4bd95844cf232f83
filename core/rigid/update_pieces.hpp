// SPDX-License-Identifier: Apache-2.0
// Updates pieces after particles melted, froze or left: finds connected pieces and their mass properties.
#pragma once
#include "core/halo/halos.hpp"
#include "core/rigid/rigid_view.hpp"

namespace thaw {

/// Value (N) of Pieces::contactLoad for pieces at the start, until their contacts are solved.
inline constexpr double unknownLoad = -1;

/// Marks particles of rigid materials as single pieces without bonds. Call it once, before the first
/// evaluation.
void markRigidParticles(const Scene& scene, Continuum& particles);

/// Makes pieces from the current particles. Pieces whose particles changed get new mass properties, and the
/// momentum and angular momentum of their particles. The ledger records the energy lost when particles join.
/// At the start it records nothing, and pieces get the mean motion of their particles. Requires: ghosts of
/// the last evaluation. Ensures: rows of the pieces of owned particles. Collective.
void updatePieces(const RigidView& view, const Halos& halos, bool atStart);

/// As updatePieces, with the pieces that Continuum::setLabel gives for owned particles.
void remakePieces(const RigidView& view, const Halos& halos, bool atStart);

}  // namespace thaw
