// Contact by distance: of vertices with vertices of other sheets, and of the same where it may touch itself, and with particles of the continuum.
#pragma once
#include "core/sheet/outer_forces.hpp"

namespace thaw {

/// Do vertices of the scene's sheets act on each other by distance, or on particles of the continuum?
bool sheetsMeet(const Scene& scene);
bool sheetsMeetContinuum(const Scene& scene);

/// Vertices of one sheet that are nearer than this at the start (m) never touch: their edges hold them apart.
double neverTouch(const SheetPlan& plan);

/// Adds to Sheets::load, energy, dissipated, heatFlow, and to force, interaction, dissipation and heatFlow of particles. Both ends of a pair
/// compute the same force, in the order (cell, id). Needs ghosts of the continuum where both meet. Collective.
void addSheetContacts(World& world, Halos halos, const SheetVelocities& now);

}  // namespace thaw
