// SPDX-License-Identifier: Apache-2.0
// Absorbs large plastic flow into the reference configuration (MKN04 3.5). It uses a push-forward, so that
// the stress rotates with the body (docs/validation/stability.md, row 13).
#pragma once
#include "core/solid/elasticity/elastic.hpp"

namespace thaw {

/// Makes the current configuration the reference of solids whose plastic strain since the last reference
/// exceeds Numerics::plasticRereference: X_ij <- x_ij, Fp^-1 <- Ve of Fe = Ve R. F becomes the identity.
/// Stress, elastic energy and weights do not change; the hourglass energy vanishes. The update is postponed
/// for solids that are inverted or nearly flat (|F^-1|^2 > 6), or whose bonds would no longer span space. The
/// vectors' copies at neighbours (Bonds::rx) are updated here. For remote solids they are updated in phase 2
/// (Boundary), by the exchanged column Solids::rereferenced. Requires: called after phase 1 of both parts and
/// breakBonds. The jump of elastic energy is added to phaseJump (J). Returns the number of solids with a new
/// reference.
std::int64_t rereference(ElasticWork& work, Solids& solids, Bonds& bonds, const ElasticStep& step,
                         ExactSum& phaseJump);

/// Range of solid rows.
struct SolidRows {
  std::size_t begin, end;
};

/// In the bonds of the groups, updates the copied vectors of neighbours in `flagged` that have a new
/// reference.
void copyReferences(ElasticWork& work, const Solids& solids, Bonds& bonds,
                    std::span<const std::uint32_t> groups, SolidRows flagged);

/// Updates the copied vectors of remote solids that took a new reference. It is part of phase 2.
void copyRemoteReferences(ElasticWork& work, const Solids& solids, Bonds& bonds);

}  // namespace thaw
