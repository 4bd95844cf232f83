// SPDX-License-Identifier: Apache-2.0
// Preparation of a scene's sheets.
#pragma once
#include "core/halo/halos.hpp"
#include "core/simulation/world/world.hpp"

namespace thaw {

/// Stores meshes and coefficients of the scene's sheets in the world, on every rank. Throws ShapeError with
/// all problems.
void prepareSheets(World& world, const MeshLoader& load);

void activateSheets(World& world);

/// Appends this rank's vertices. Not collective.
void sampleSheets(World& world, Halos halos, const MeshLoader& load);

}  // namespace thaw
