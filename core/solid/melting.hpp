// SPDX-License-Identifier: Apache-2.0
// Elastic energy of particles that soften and melt, and removal of the bonds of melted ones.
#pragma once
#include "core/solid/elasticity/elastic.hpp"

namespace thaw {

/// Updates Solids::liquid and Solids::energy after a change of the liquid fraction, at the positions of the
/// last force evaluation. Adds the energy loss to phaseJump (J). Requires: Solids::energy of that evaluation.
void recordSoftening(const ElasticWork& work, const Continuum& particles, Solids& solids, const Bonds& bonds,
                     ExactSum& phaseJump);

/// Sets Solids::melted of owned solids from the phase of their particles. The caller then sends this column
/// along the bonds.
void markMelted(const Continuum& particles, Solids& solids);

/// Drops (weight 0) every bond of owned solids with a melted end, so that both ends lose it. The energy of
/// these solids is recomputed at the positions of the last force evaluation. The loss is added to phaseJump
/// (J). Requires: called at the end of a step, after the update of the liquid fraction (with Solids::energy
/// up to date) and before anything moves. Returns the number of solids that lost bonds.
std::int64_t dropMeltedBonds(ElasticWork& work, const Continuum& particles, Solids& solids, Bonds& bonds,
                             ExactSum& phaseJump);

}  // namespace thaw
