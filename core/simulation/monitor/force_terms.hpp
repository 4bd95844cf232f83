// SPDX-License-Identifier: Apache-2.0
// Forces on one particle, by term, for the message of a failed run.
#pragma once
#include "core/simulation/workspace/step_tools.hpp"
#include "core/simulation/world/world.hpp"

namespace thaw {

/// Magnitudes of forces (N). pressure: pressure and surface tension of the surrounding liquid, which depend
/// on positions alone. With the incompressible solver, it is the prepared impulse divided by the step.
/// viscosity: all resistance in the liquid. contact: contact of solids. outside: forces added by the program.
struct ForceTerms {
  double elastic = 0, pressure = 0, viscosity = 0, contact = 0, walls = 0, outside = 0, weight = 0;
  bool atWall = false;  ///< closer than one spacing
};

/// Returns the forces on an owned particle after a failed step. It repeats all sums, one term at a time.
/// Forces, velocities and the ledger are restored. Other sums are not, so the caller must roll back or end
/// the run.
ForceTerms forceTerms(World& world, StepTools& tools, std::size_t row);

}  // namespace thaw
