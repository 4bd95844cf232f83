// SPDX-License-Identifier: Apache-2.0
// Detects a stall of relaxation with adaptive sampling.
#pragma once
#include <cstdint>

#include "core/scene/shape.hpp"

namespace thaw {

/// Progress of a relaxation. It is the same on all ranks if the inputs are the same.
struct RelaxProgress {
  double least = never;     ///< 1, smallest force over stiffness times spacing, at the current number of
                            ///< particles
  std::int64_t most = 0;    ///< largest number of particles
  std::int64_t gained = 0;  ///< iteration of the last significant gain in force or number of particles
};

/// Returns the number of iterations without gain after which relaxation has stalled. It is proportional to
/// the number of particles along a surface, because disturbances need this many iterations to cross the
/// surface.
std::int64_t relaxStallLimit(std::int64_t particles);

/// Updates the progress with iteration `done`. Returns false after relaxStallLimit iterations in which the
/// largest force has not decreased by 10 % and the surface has not grown by 2 %. Relaxation of a bounded
/// number of particles ends, since each number allows about 200 gains down to a force of 1e-9.
bool makesProgress(RelaxProgress& progress, std::int64_t done, double force, std::int64_t particles);

}  // namespace thaw
