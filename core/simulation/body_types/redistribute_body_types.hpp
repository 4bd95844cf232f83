// SPDX-License-Identifier: Apache-2.0
// Redistribution of the rows of body types to the ranks that own their cells. The continuum defines the
// ownership of cells.
#pragma once
#include "core/halo/halos.hpp"
#include "core/scene/scene_warning.hpp"
#include "core/simulation/workspace/redistribution_work.hpp"
#include "core/simulation/world/world.hpp"

namespace thaw {

/// Wraps positions at periodic sides, and records and drops rows that left through open sides. Then it
/// migrates rows and sorts them by (cell, id). Ghosts are dropped. dt (s): length of the last step.
/// Collective.
void redistributeBodyTypes(World& world, Halos halos, RedistributionWork& work, double dt = 0);

/// Activates the columns of the scene's body types.
void activateBodyTypes(World& world);

/// Appends this rank's rows of all body types at time 0. Returns the positions of each oriented body's
/// particles, on all ranks. Throws as sampleBodies does. Collective.
std::vector<std::vector<Vec3d>> sampleBodyTypes(World& world, Halos halos, SortBuffers& sort,
                                                const MeshLoader& load, std::vector<SceneWarning>& warnings);

/// Returns whether all positions and velocities of this rank's rows are finite.
bool bodyTypesAreFinite(const World& world);

/// Removes all rows of the body types.
void clearBodyTypes(World& world);

}  // namespace thaw
