// SPDX-License-Identifier: Apache-2.0
// Interactions of vertices by distance: repulsion, attraction, and contact with continuum and oriented
// particles. Contact between sheets is in mesh_contact.hpp.
#pragma once
#include "core/halo/halos.hpp"
#include "core/sheet/forces/outer_forces.hpp"

namespace thaw {

/// The first function returns whether the scene's sheets interact by distance with each other or themselves,
/// the second whether they interact with the continuum.
bool sheetsInteract(const Scene& scene);
bool sheetsTouchContinuum(const Scene& scene);

/// Returns the initial distance (m) below which vertices of a sheet neither repel nor attract, because edges
/// keep their distance.
double exclusionDistance(const SheetPlan& plan);

/// Adds to load, energy, dissipated and heatFlow of sheets, and to force, interaction, dissipation and
/// heatFlow of particles. Both ends of a pair compute the same force, in (cell, id) order. Requires:
/// ghosts of the continuum if the two touch. Collective.
void addSheetContacts(const SheetView& view, Halos halos, const SheetVelocities& now);

}  // namespace thaw
