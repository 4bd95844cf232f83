// Sheets of a scene, made ready.
#pragma once
#include "core/geometry/signed_distance.hpp"
#include "core/step.hpp"

namespace thaw {

/// Radius (m) within which the scene's sheets act on anything by distance: cells are at least as long.
double sheetReach(const Scene& scene);

void activateSheets(World& world);

/// Appends this rank's share of the vertices. Throws SceneProblems as sampleBodies does. Collective.
void sampleSheets(World& world, Halos halos, const MeshLoader& load);

}  // namespace thaw
