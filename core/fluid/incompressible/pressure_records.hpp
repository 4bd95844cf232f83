// The iterates of the pressure solver in the records that pair sums read (core/fluid/records.hpp).
#pragma once
#include "core/fluid/records.hpp"

namespace thaw {

/// 1/m (1/kg) of rows [0, rows) into state.c, 0 of those that are held or driven: in the place of the
/// temperature, which is done with.
void packMobility(const RecordContext& context, const Continuum& particles, std::size_t rows,
                  PairRecords& records);

/// Continuum::trialPressure of rows [begin, end) into state.a.
void packTrialPressure(const RecordContext& context, const Continuum& particles, std::size_t begin,
                       std::size_t end, PairRecords& records);

/// Continuum::trialVelocity of rows [begin, end) into motion.
void packTrialVelocity(const RecordContext& context, const Continuum& particles, std::size_t begin,
                       std::size_t end, PairRecords& records);

/// Liquid fraction of a row as the sums of this step took it.
float packedFraction(const RecordContext& context, const PairRecords& records, std::size_t row);

}  // namespace thaw
