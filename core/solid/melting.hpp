// Bonds of what has just melted go, and what they held is booked.
#pragma once
#include "core/solid/elastic.hpp"

namespace thaw {

/// Solids::melted of owned slots from the phase of their particles; then to be sent along the bonds.
void markMelted(const Continuum& particles, Solids& solids);

/// Drops (weight 0) every bond of owned slots of which an end is marked as melted, so that both ends lose it.
/// Slots that lose bonds get their energy computed anew at the places of the last force evaluation, and what
/// it lost is added to phaseJump (J): call at the end of a step, after the liquid fraction was renewed
/// (Solids::energy is up to date with it) and before anything moves. Returns the number of slots that lost
/// bonds.
std::int64_t dropMeltedBonds(ElasticWork& work, const Continuum& particles, Solids& solids, Bonds& bonds,
                             ExactSum& phaseJump);

}  // namespace thaw
