// SPDX-License-Identifier: Apache-2.0
// One time step. Readers of the code should start here.
#pragma once
#include <cstdint>
#include <optional>

#include "core/halo/halos.hpp"
#include "core/simulation/time/monitor_limits.hpp"
#include "core/simulation/time/step_limits.hpp"
#include "core/simulation/workspace/step_tools.hpp"
#include "core/simulation/world/world.hpp"

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

/// Migrates and sorts particles and searches neighbours. Then computes forces, heat flows and all other
/// data that depend on positions, velocities and temperatures. dt (s): last step, 0 at the start. Requires:
/// particles in any order on any rank. Ensures: each particle is on the rank that owns its cell, sorted by
/// (cell, id), if cells are needed (needsOrder).
void evaluate(World& world, Halos halos, StepTools& tools, double dt);

/// Reduces the limits of all ranks and sets the next step in the clock. Collective.
StepOutcome reduceStep(World& world, Halos halos, StepTools& tools, StepOutcome here, Requests requests);

/// The same, with the context of a step.
void evaluate(StepContext& context);
StepOutcome reduceStep(StepContext& context, StepOutcome here, Requests requests);

/// One leap-frog step of Clock::dt, shortened to hit the next frame time. Requires: accelerations, from one
/// call of evaluate and reduceStep before the first step. Collective; the same bits on any number of ranks.
StepOutcome step(World& world, Halos halos, StepTools& tools, Requests requests);

/// Returns the exact total mass (kg) of all ranks. Collective.
double totalMass(const Continuum& particles, Reducer& all);

}  // namespace thaw
