// What acts on vertices by distance: pushes and pulls between them, contact with particles of the continuum
// and with oriented ones; and the way to the contacts of sheets with each other (mesh_contact.hpp).
#pragma once
#include "core/sheet/outer_forces.hpp"

namespace thaw {

/// Do the scene's sheets act on each other or on themselves by distance, or on particles of the continuum?
bool sheetsMeet(const Scene& scene);
bool sheetsMeetContinuum(const Scene& scene);

/// Vertices of one sheet that are nearer than this at the start (m) neither push nor pull: their edges hold
/// them apart.
double neverTouch(const SheetPlan& plan);

/// Adds to Sheets::load, energy, dissipated, heatFlow, and to force, interaction, dissipation and heatFlow of
/// particles. Both ends of a pair compute the same force, in the order (cell, id). Needs ghosts of the
/// continuum where both meet. Collective.
void addSheetContacts(World& world, Halos halos, const SheetVelocities& now);

}  // namespace thaw
