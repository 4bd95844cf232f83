// SPDX-License-Identifier: Apache-2.0
// Packing of bond end data: Solids::end and ElasticWork::velocityDrag.
#pragma once
#include "core/solid/elasticity/elastic.hpp"

namespace thaw {

/// Packs references of rows [first, last) if bonds have no vectors. Call it after every bond update for
/// changed rows.
void packReferences(const ElasticWork& work, Solids& solids, std::size_t first, std::size_t last);

/// Packs displacements (or positions) of rows [first, last).
void packPositions(const ElasticWork& work, Solids& solids, std::size_t first, std::size_t last);

/// Packs velocities and drag of rows [first, last) if bonds are damped. Call it after phase 1.
void packVelocityDrag(ElasticWork& work, const Solids& solids, std::size_t first, std::size_t last);

}  // namespace thaw
