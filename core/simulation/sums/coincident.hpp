// SPDX-License-Identifier: Apache-2.0
// Particles at the same position.
#pragma once
#include <cstdint>

#include "core/fluid/pair_sums/records.hpp"
#include "core/simulation/world/world.hpp"

namespace thaw {

/// Applies tiny opposite impulses to coincident particles, in a direction derived from the id
/// (docs/validation/stability.md, row 9). before: Counters::coincidentPairs before the sums. Call it at the
/// end of an evaluation; it takes effect in the next step.
void separateCoincident(World& world, const PairRecords& records, std::int64_t before);

}  // namespace thaw
