// How many iterations the solvers of a run take.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "core/step.hpp"

namespace thaw {

/// Of one solver: iterations of the last step, and the mean of all steps.
struct SolverUse {
  const char* name;
  std::int64_t last;
  double mean;
};

/// Of the solvers that the scene has. On the first rank, whose counters have them.
std::vector<SolverUse> solversOf(const World& world, const StepTools& tools);

}  // namespace thaw
