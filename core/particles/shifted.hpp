// SPDX-License-Identifier: Apache-2.0
// Particles that move with an additional shifting velocity.
#pragma once
#include "core/particles/continuum.hpp"

namespace thaw {

/// Returns true if a particle moves with velocity + shiftingVelocity, false if with velocity alone.
inline bool isShifted(const Continuum& p, std::size_t i) {
  return p.shiftingVelocity.active && !(p.clamped.active && p.clamped[i]);
}

}  // namespace thaw
