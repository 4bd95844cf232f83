// SPDX-License-Identifier: Apache-2.0
// One time step. Readers of the code should start here.
#pragma once
#include "core/halo/halos.hpp"
#include "core/simulation/step_outcome.hpp"
#include "core/simulation/workspace/step_tools.hpp"
#include "core/simulation/world/world.hpp"

namespace thaw {

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
