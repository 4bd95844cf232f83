// SPDX-License-Identifier: Apache-2.0
// Preparation of a scene's sheets.
#pragma once
#include "core/halo/halos.hpp"
#include "core/scene/modules.hpp"
#include "core/sheet/data/sheets.hpp"

namespace thaw {

/// Stores meshes and coefficients of the scene's sheets, on every rank. Throws ShapeError with
/// all problems.
void prepareSheets(SheetBodies& sheets, const Scene& scene, const MeshLoader& load);

void activateSheets(SheetBodies& sheets, const Scene& scene, const Modules& modules);

/// Appends this rank's vertices. Not collective.
void sampleSheets(SheetBodies& sheets, const Scene& scene, Halos halos, const MeshLoader& load);

}  // namespace thaw
