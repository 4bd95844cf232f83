// The sheets' part of a step (DS): the exact solution over the step, with forces of neighbours and contacts
// before and after it.
#pragma once
#include "core/step.hpp"

namespace thaw {

/// First part: places after dt (s), velocities but for the forces there. Needs the loads of the last
/// evaluation. Plastic flow follows.
void moveSheets(World& world, double dt);

/// Rows that are about to leave the domain, after moveSheets by dt (s): what the end of the step would have
/// booked of them, with the loads of its beginning for those of its end. Nothing at dt 0.
void closeLeavers(World& world, std::span<const std::uint32_t> rows, double dt);

/// Brings the edges' table up to date after rows went home, and makes all bonds at the start. Collective.
void linkSheets(World& world, Halos halos, StepTools& tools);

/// All forces at the places of now, into Sheets::load, and into the continuum's what it feels of sheets;
/// energies and books. dt (s): of the step that led here, 0 at the start. Needs vertices and particles at
/// home, and ghosts of the continuum where both meet. Collective.
void loadSheets(World& world, Halos halos, StepTools& tools, double dt);

/// Second part: velocities get the forces at the new places; heat follows.
void kickSheets(World& world, double dt);

/// The longest step (s) that is stable for this rank's vertices; `never` where any is. To be reduced over
/// ranks.
double sheetStepLimit(const World& world);

}  // namespace thaw
