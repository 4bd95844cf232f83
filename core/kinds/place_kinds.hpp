// Brings the rows of the further kinds to the ranks that own their cells: which rank owns which cell is the
// continuum's business.
#pragma once
#include "core/kinds/start_warnings.hpp"
#include "core/step.hpp"

namespace thaw {

/// Wraps positions at periodic sides, books and drops what left through open ones, migrates and sorts by
/// (cell, id); ghosts are dropped. dt (s): of the step that led here. Collective.
void bringKindsHome(World& world, Halos halos, StepTools& tools, double dt = 0);

/// The same of oriented particles after births (appended, with cell 0) and deaths (mass 0): nothing is
/// wrapped or booked. Collective.
void placeOriented(World& world, Halos halos, StepTools& tools);

/// Activates the columns of the kinds that the scene has.
void activateKinds(World& world);

/// Appends this rank's share of the rows of all kinds at time 0. Returns the places of the particles of each
/// oriented body, on all ranks. Throws as sampleBodies does. Collective.
std::vector<std::vector<Vec3d>> sampleKinds(World& world, Halos halos, StepTools& tools,
                                            const MeshLoader& load, std::vector<SceneWarning>& warnings);

/// Are all places and velocities of this rank's rows finite numbers?
bool finiteKinds(const World& world);

/// Empties all kinds.
void emptyKinds(World& world);

}  // namespace thaw
