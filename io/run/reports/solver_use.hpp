// SPDX-License-Identifier: Apache-2.0
// Iterations of the solvers of a run.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "core/simulation/workspace/step_tools.hpp"
#include "core/simulation/world/world.hpp"

namespace thaw {

/// A solver: iterations of the last step, and the mean over all steps.
struct SolverUse {
  const char* name;
  std::int64_t last;
  double mean;
  double residual = 0, tolerance = 0;  ///< m/s, of contacts in the last step; 0 for other solvers
  double overlap = 0;                  ///< m, largest overlap of contacts since the start of the program
};

/// Returns the use of each solver of the scene. Valid on the first rank only, whose counters contain it.
std::vector<SolverUse> solversOf(const World& world, const StepTools& tools);

}  // namespace thaw
