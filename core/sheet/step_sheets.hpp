// SPDX-License-Identifier: Apache-2.0
// Sheets' part of a step (DS): the exact solution over the step, with forces of neighbours and contacts
// before and after it.
#pragma once
#include "core/halo/halos.hpp"
#include "core/sheet/data/sheet_view.hpp"
#include "core/time/phase_times.hpp"

namespace thaw {

/// First part: positions after dt (s), and velocities up to the forces there, then plastic flow. Requires:
/// loads of the last evaluation.
void moveSheets(const SheetView& view, double dt);

/// Records the rest of the step for rows that leave the domain after moveSheets by dt (s), with their loads
/// at its start. Does nothing for dt 0.
void finaliseRemoved(const SheetView& view, std::span<const std::uint32_t> rows, double dt);

/// Updates the table of edges after redistribution, and makes all bonds at the start. Collective.
void linkSheets(SheetBodies& sheets, Halos halos, PhaseTimes& times);

/// Computes all forces at the current positions into Sheets::load and the continuum's forces, with energies
/// and ledger entries. dt (s): the last step, 0 at the start. Requires: redistributed vertices and particles,
/// and ghosts of the continuum where both touch. Collective.
void loadSheets(const SheetView& view, Halos halos, PhaseTimes& times, double dt);

/// Second part: updates velocities with the forces at the new positions, then temperatures.
void kickSheets(const SheetView& view, double dt);

/// Returns the longest stable step (s) of this rank's vertices; `never` if any is. To be reduced over ranks.
double sheetStepLimit(const SheetBodies& sheets, const Scene& scene, const Clock& clock);

}  // namespace thaw
