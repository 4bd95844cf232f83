// SPDX-License-Identifier: Apache-2.0
// Change of the density at rest of particles that melt and freeze (Continuum::restDensity).
#pragma once
#include <span>

#include "core/fluid/pair_sums/records.hpp"
#include "core/heat/heat_view.hpp"

namespace thaw {

/// Moves densities at rest of owned, awake particles towards their targets (targetRestDensity), over a step
/// of dt (s). The equations are in docs/theory/density.md.
/// - A volume changes at most at a rate of restDensityRate c / h, so melting starts no sound wave.
/// - A carried relative density changes with the volume, so the pressure moves the neighbours.
/// - Ledger::phaseJump records the change of compression and surface energy. It is exact for carried
///   densities, else of first order in the differences between neighbours.
/// pairEnergy: J, compression and tension of owned rows in the last evaluation; may be empty without tension.
void updateRestDensities(const HeatView& view, const RecordContext& records,
                         std::span<const double> pairEnergy, double dt);

/// Largest rate of volume change over speed of sound and support radius.
inline constexpr double restDensityRate = 1e-3;

/// Returns the extra work (J) of the first half kick, which used the pressure at compression `before` instead
/// of the present one. The carried density changed after the kick. Requires: Continuum::compressionRate of
/// the last step. dt: s, the step.
double workOfLateKick(const RecordContext& records, const Continuum& particles, std::size_t row,
                      double before, double dt);

}  // namespace thaw
