// SPDX-License-Identifier: Apache-2.0
// Interactions of vertices by distance: repulsion and attraction, and contact with continuum and oriented
// particles. Sheet-sheet contact is in mesh_contact.hpp.
#pragma once
#include "core/halo/halos.hpp"
#include "core/sheet/forces/outer_forces.hpp"

namespace thaw {

/// Return whether the scene's sheets interact by distance with each other or themselves, or with the
/// continuum.
bool sheetsInteract(const Scene& scene);
bool sheetsTouchContinuum(const Scene& scene);

/// Returns the initial distance (m) below which vertices of a sheet neither repel nor attract: edges keep
/// them apart.
double exclusionDistance(const SheetPlan& plan);

/// Adds to Sheets::load, energy, dissipated, heatFlow, and to force, interaction, dissipation and heatFlow of
/// particles. Both ends of a pair compute the same force, in (cell, id) order. Requires: ghosts of the
/// continuum where both touch. Collective.
void addSheetContacts(const SheetView& view, Halos halos, const SheetVelocities& now);

}  // namespace thaw
