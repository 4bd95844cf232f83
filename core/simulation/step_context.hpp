// SPDX-License-Identifier: Apache-2.0
// A step in progress.
#pragma once
#include "core/halo/exchange.hpp"
#include "core/halo/halos.hpp"
#include "core/simulation/sums/pass_rows.hpp"
#include "core/simulation/time/step_reduction.hpp"
#include "core/simulation/workspace/step_tools.hpp"
#include "core/simulation/world/world.hpp"
#include "core/walls/vanished_walls.hpp"
#include "core/walls/wall_forces.hpp"

namespace thaw {

/// The data that the phases of a step, or of an evaluation of all forces, read and change.
struct StepContext {
  World& w;
  Halos halos;
  StepTools& t;
  double dt;    ///< s, length of the step; 0 for an evaluation without a step
  double time;  ///< s, time at the end of the step
  WallContext walls;
  bool leftBonds = false;    ///< a particle with bonds left the domain
  bool bondsForm = false;    ///< bonds form in this step on some rank
  bool justFrozen = false;   ///< particles froze in the last step, so contacts record the jump of energy
  bool contactNear = false;  ///< with Modules::rareContact: unbonded solids of this rank touch, or will touch
                             ///< soon
  VanishedWalls vanished = {};                ///< has walls only if some vanished in this step
  PassRows rows = {};                         ///< rows of the present pass of sums
  Exchange solidPositions = {}, stress = {};  ///< in flight
  StepLimits limits = {};                     ///< s, of this rank's particles
  StepReduction reduction = {};
  StepLimits commonLimits = {};   ///< s, of all ranks
  double longestSubstep = never;  ///< s
  bool finite = true;             ///< all values of all ranks are finite
  bool exceededReach = false;  ///< a particle of a body type moved farther than its neighbours were searched
};

/// Returns the context of a step. dt: s, as StepContext::dt. Requires: the clock at the beginning of the
/// step.
StepContext stepContext(World& world, Halos halos, StepTools& tools, double dt);

/// Runs the calls of the scene's modules in this phase.
inline void runPhase(ModulePhase phase, StepContext& context) { context.t.phases.run(phase, context); }

}  // namespace thaw
