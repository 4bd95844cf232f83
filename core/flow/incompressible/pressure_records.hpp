// SPDX-License-Identifier: Apache-2.0
// Iterates of the pressure solver in the records of pair sums (core/fluid/pair_sums/records.hpp).
#pragma once
#include "core/fluid/pair_sums/records.hpp"

namespace thaw {

/// Packs 1/m (1/kg) of rows [0, rows) into pressurePhaseHeat.c, 0 for clamped and driven particles. It
/// overwrites the temperature, which is not read after the forces.
void packMobility(const RecordContext& context, const Continuum& particles, std::size_t rows,
                  PairRecords& records);

/// Packs Continuum::trialPressure of rows [begin, end) into pressurePhaseHeat.a. With corrected gradients,
/// its product with 1 + Continuum::correction is also packed into pressureDiagonal and pressureOffDiagonal.
void packTrialPressure(const RecordContext& context, const Continuum& particles, std::size_t begin,
                       std::size_t end, PairRecords& records);

/// Packs Continuum::trialVelocity of rows [begin, end) into velocityViscosity.
void packTrialVelocity(const RecordContext& context, const Continuum& particles, std::size_t begin,
                       std::size_t end, PairRecords& records);

/// Returns the liquid fraction of a row as used by the sums of this step.
float packedFraction(const RecordContext& context, const PairRecords& records, std::size_t row);

}  // namespace thaw
