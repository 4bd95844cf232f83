// SPDX-License-Identifier: Apache-2.0
// Change of the rest density of particles that melt or freeze (Continuum::restDensity).
#pragma once
#include <span>

#include "core/fluid/pair_sums/records.hpp"
#include "core/heat/heat_view.hpp"

namespace thaw {

/// Moves rest densities of owned, awake particles towards their targets (targetRestDensity), over a step of
/// dt (s). The equations are in docs/theory/density.md.
/// - A volume changes at a rate of at most restDensityRate c / h, so melting causes no sound wave.
/// - A carried relative density changes with the volume, so the pressure displaces the neighbours.
/// - Ledger::phaseJump records the change of compression and surface energy. The record is exact for
///   carried densities, and otherwise of first order in the differences between neighbours.
/// pairEnergy: J, compression and tension of owned rows in the last evaluation; may be empty without tension.
void updateRestDensities(const HeatView& view, const RecordContext& records,
                         std::span<const double> pairEnergy, double dt);

/// Largest rate of volume change, in units of sound speed over support radius.
inline constexpr double restDensityRate = 1e-3;

/// Returns the extra work (J) of the first half kick. The carried density changed after the kick, so the kick
/// used the pressure at compression `before` instead of the present one. dt: s, the step. Requires:
/// Continuum::compressionRate of the last step.
double workOfLateKick(const RecordContext& records, const Continuum& particles, std::size_t row,
                      double before, double dt);

}  // namespace thaw
