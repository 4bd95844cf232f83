// SPDX-License-Identifier: Apache-2.0
// Cost of a whole run from one with a larger spacing, for scenes whose first steps say little about it.
#pragma once
#include <optional>

#include "io/commands/check/setting_trials.hpp"
#include "parallel/communicator.hpp"

namespace thaw {

/// Growth of the number and the cost of steps after the first ones.
struct RunGrowth {
  double spacing = 0;  ///< m, of the run that was measured
  double steps = 1;    ///< 1, number of steps over that with the step of the start
  double cost = 1;     ///< 1, mean time of a step over that of the first steps
};

/// Runs the scene with a larger spacing until its end, in memory, for some seconds. The time of the rest is
/// that of the later half so far. Contacts, breaking and melting of rigid pieces thus count, which the first
/// steps do not have. spacing: m, of the scene. estimate: s, for the whole run, by its first steps. Returns
/// nothing if the run would take long even with the largest spacing, or if it fails. Collective, the same
/// result on all ranks.
std::optional<RunGrowth> growthOfCoarseRun(const Communicator& comm, const TriedScene& scene, double spacing,
                                           double estimate);

}  // namespace thaw
