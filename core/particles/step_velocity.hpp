// SPDX-License-Identifier: Apache-2.0
// Velocity with which a particle moved in the last step.
#pragma once
#include "core/particles/continuum.hpp"
#include "core/particles/shifted.hpp"

namespace thaw {

/// Returns true if a particle moved in substeps in the last step, which had `substeps` substeps. Unlike a
/// test of the solid index, this also works for ghosts, which have none.
inline bool movedInSubsteps(const Continuum& p, std::size_t i, int substeps) {
  return substeps > 1 && p.stepMeanVelocity.active && p.stepMeanVelocity[i] != Vec3d{};
}

/// Velocity (m/s) with which a particle moved in the last step: without shifting, and with it.
struct StepVelocity {
  Vec3d flow, all;
};
inline StepVelocity stepVelocity(const Continuum& p, std::size_t i, int substeps) {
  if (movedInSubsteps(p, i, substeps)) return {p.stepMeanVelocity[i], p.stepMeanVelocity[i]};
  const Vec3d& v = p.velocity[i];
  return {v, isShifted(p, i) ? v + p.shiftingVelocity[i] : v};
}

}  // namespace thaw
