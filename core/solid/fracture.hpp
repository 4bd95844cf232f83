// SPDX-License-Identifier: Apache-2.0
// Fracture of bonds beyond a stretch limit.
#pragma once
#include "core/solid/elasticity/elastic.hpp"

namespace thaw {

/// Breaks (weight 0) bonds of owned solids. A bond breaks if its length exceeds breakStretch times its
/// reference length, and its ends are outside the contact distance. The stretch limit is the smaller one of
/// the two materials. The reference length is the longer one of the two ends. Both ends use the same bits, so
/// they break the same bonds. Call it after phase 1 of both parts; it repeats phase 1 for solids that lost
/// bonds. phaseJump (J) receives the elastic energy of the broken bonds, minus the work of the changed forces
/// in the kick of the step. Requires: Solids::velocity of owned and remote rows, id and material of remote
/// rows. Returns the number of broken bonds, counted at the end with the smaller id.
std::int64_t breakBonds(ElasticWork& work, Solids& solids, Bonds& bonds, const ElasticStep& step,
                        ExactSum& phaseJump);

}  // namespace thaw
