// SPDX-License-Identifier: Apache-2.0
// Change of the density at rest of particles that melt and freeze (Continuum::restDensity).
#pragma once
#include "core/fluid/pair_sums/records.hpp"
#include "core/heat/heat_view.hpp"

namespace thaw {

/// Moves densities at rest of owned, awake particles towards their targets (targetRestDensity), over a step
/// of dt (s). A volume changes at most at a rate of restDensityRate c / h, so that a particle that melts at
/// once does not start a sound wave. A carried relative density changes by the ratio of the volumes, so the
/// pressure moves the neighbours. The change of compression and surface energy is recorded in
/// Ledger::phaseJump: exact for carried densities, else to first order in the differences between neighbours.
void updateRestDensities(const HeatView& view, const RecordContext& records, double dt);

/// Largest rate of volume change over speed of sound and support radius.
inline constexpr double restDensityRate = 1e-3;

}  // namespace thaw
