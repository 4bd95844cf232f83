// SPDX-License-Identifier: Apache-2.0
// Detects a stall of relaxation with adaptive sampling.
#pragma once
#include <cstdint>

#include "core/scene/shape.hpp"

namespace thaw {

/// Progress of a relaxation; the same on all ranks, if its inputs are.
struct RelaxProgress {
  double least = never;     ///< least force over stiffness times spacing, at the current number of particles
  std::int64_t most = 0;    ///< largest number of particles
  std::int64_t gained = 0;  ///< iteration of the last significant gain of either
};

/// Returns the iterations without gain after which relaxation is stalled. A disturbance crosses a surface in
/// a multiple of the number of particles along it.
std::int64_t relaxStallLimit(std::int64_t particles);

/// Updates the progress with iteration `done`. Returns false after relaxStallLimit iterations in which the
/// largest force has not fallen by 10 % and the surface has not grown by 2 %. Relaxation of a bounded
/// population ends: each size allows about 200 gains down to 1e-9.
bool makesProgress(RelaxProgress& progress, std::int64_t done, double force, std::int64_t particles);

}  // namespace thaw
