// Bonds break past a stretch limit.
#pragma once
#include "core/solid/elastic.hpp"

namespace thaw {

/// Breaks (weight 0) every bond of owned slots whose current length exceeds breakStretch times its reference
/// length: the smaller limit of both ends' materials, the longer of both ends' reference vectors; not of ends
/// that are within the contact distance. Both ends decide alike, from the same bits. Call after phase 1 of
/// both parts; slots that lost bonds have phase 1 repeated. The elastic energy that the broken bonds no
/// longer hold is added to phaseJump (J), less what the change of forces within the step gives to the kick:
/// needs Solids::velocity of owned and remote rows. Returns the number of broken bonds, each counted at its
/// end with the smaller id. Needs remote rows' id and material.
std::int64_t breakBonds(ElasticWork& work, Solids& solids, Bonds& bonds, const ElasticStep& step,
                        ExactSum& phaseJump);

}  // namespace thaw
