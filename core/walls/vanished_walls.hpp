// SPDX-License-Identifier: Apache-2.0
// Energy of obstacles that vanish (Obstacle::until). Particles keep their positions, but lose the springs of
// the obstacle, its part of a summed density, and its part of their surface energy. The change of stored
// energy is the obstacle's work.
#pragma once
#include <vector>

#include "core/fluid/laws/surface_energy.hpp"
#include "core/walls/wall_forces.hpp"

namespace thaw {

/// Walls and contacts of a step, as if no wall had vanished in it.
struct VanishedWalls {
  Walls walls;
  WallContacts contacts;
  /// Springs of the contacts, with the contact offsets before the walls vanished.
  std::vector<WallSpring> springs;
};

/// Returns true if a wall that was present at a time (s) has vanished since.
bool someVanished(const Walls& walls, double since);

/// Finds the contacts with all walls that were present at a time (s). Distances from vanished walls are those
/// at the middle of the step, since the kick at its end lacks the force of these walls. Call it before
/// findWallContacts.
void findVanished(const WallContext& context, double since, VanishedWalls& vanished);

/// Normalisation of surface energies and of densities.
struct LiquidMeasure {
  const SurfaceMeasure& surface;
  double inverseLatticeSum;  ///< factor that turns sums over V W into relative densities
};

/// Records the change of stored energy in Ledger::wallWork. now: contacts without the walls that vanished.
/// Requires: relativeDensity, surfaceGradient and surfaceColour from sums over neighbours, without walls.
void recordVanished(const WallContext& context, const LiquidMeasure& measure, VanishedWalls& vanished,
                    const WallContacts& now);

}  // namespace thaw
