// SPDX-License-Identifier: Apache-2.0
// Cost of a whole run, estimated by a run with a larger spacing. For scenes whose first steps are not
// representative.
#pragma once
#include <optional>

#include "io/commands/check/setting_trials.hpp"
#include "parallel/communicator.hpp"

namespace thaw {

/// Growth of the number and the cost of steps after the first ones.
struct RunGrowth {
  double spacing = 0;  ///< m, of the run that was measured
  double steps = 1;    ///< 1, number of steps, divided by the number at the initial time step
  double cost = 1;     ///< 1, mean cost of a step, divided by that of the first steps
};

/// Runs the scene with a larger spacing until its end, in memory, for some seconds. Extrapolates an
/// unfinished run from the later half of its simulated time. The estimate thus includes contacts, breaking
/// and melting of rigid pieces, which the first steps lack. spacing: m, of the scene. estimate: s, for the
/// whole run, from its first steps. Returns nothing if the run would take long even with the largest spacing,
/// or if it fails. Collective, the same result on all ranks.
std::optional<RunGrowth> growthOfCoarseRun(const Communicator& comm, const TriedScene& scene, double spacing,
                                           double estimate);

}  // namespace thaw
