// SPDX-License-Identifier: Apache-2.0
// Result of a step, and requests of ranks after it.
#pragma once
#include <cstddef>
#include <optional>

#include "core/simulation/time/monitor_limits.hpp"
#include "core/simulation/time/step_limits.hpp"

namespace thaw {

/// Actions that a rank requests after a step. A request on one rank triggers the action on all ranks.
struct Requests {
  bool stop = false, report = false, checkpoint = false;
};

/// Common result of all ranks after a step.
struct StepOutcome {
  Limit limitedBy = Limit::Scene;
  Requests requests;                ///< requests of any rank
  Failure failure = Failure::None;  ///< result of the stability monitor
  bool finite = true;  ///< false: a value is not finite; `bad` is its row on the rank that has it
  bool badHere = false;
  std::size_t bad = 0;
  std::optional<LargestRates> largest;  ///< on this rank, if the kick computed them
  double surfaceMove2 = 0;  ///< m^2, squared largest displacement of a particle since the last surface
                            ///< update; 0 without a surface
};

}  // namespace thaw
