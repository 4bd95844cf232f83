// Sheets of a scene, made ready.
#pragma once
#include "core/step.hpp"

namespace thaw {

/// Meshes and coefficients of the scene's sheets, into the world; every rank does it. Throws ShapeError with
/// all problems.
void prepareSheets(World& world, const MeshLoader& load);

void activateSheets(World& world);

/// Appends this rank's share of the vertices. Not collective.
void sampleSheets(World& world, Halos halos, const MeshLoader& load);

}  // namespace thaw
