// SPDX-License-Identifier: Apache-2.0
// Apparent viscosity of liquids with a flow law. It is the viscosity at each particle's shear rate, which
// follows from the velocities of neighbours and walls.
#pragma once
#include "core/fluid/pair_sums/records.hpp"
#include "core/walls/wall_forces.hpp"

namespace thaw {

/// Sets Continuum::apparentViscosity of owned rows whose material has a flow law. A no-slip wall counts as
/// one neighbour at its nearest point. It has the wall's velocity and the weight of the liquid layers it
/// replaces. With an exponent n > 1 the new value is the mean old^(1-1/n) new^(1/n), so that implicit steps
/// do not oscillate. Requires: records, lists and wall contacts of this step.
void findApparentViscosity(const WallContext& walls, const WallContacts& contacts, const PairSums& sums);

/// Packs the apparent viscosity of rows [begin, end) into the records. Requires: apparent viscosities of
/// ghosts.
void packApparentViscosity(const RecordContext& context, const Continuum& particles, std::size_t begin,
                           std::size_t end, PairRecords& records);

}  // namespace thaw
