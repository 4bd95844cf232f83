// SPDX-License-Identifier: Apache-2.0
// Sheets' part of a step (DS): the exact solution over the step. Forces of neighbours and contacts act before
// and after it.
#pragma once
#include "core/halo/halos.hpp"
#include "core/sheet/data/sheet_view.hpp"
#include "core/time/phase_times.hpp"

namespace thaw {

/// First part: updates positions over dt (s), and velocities except for the forces at the new positions. Then
/// applies plastic flow. Requires: loads of the last evaluation.
void moveSheets(const SheetView& view, double dt);

/// Completes the step's records for rows that leave the domain after moveSheets over dt (s), with their loads
/// at the start of the step. Does nothing for dt = 0.
void finaliseRemoved(const SheetView& view, std::span<const std::uint32_t> rows, double dt);

/// Updates the table of edges after redistribution. At the start, creates all bonds. Collective.
void linkSheets(SheetBodies& sheets, Halos halos, PhaseTimes& times);

/// Adds all forces at the current positions to Sheets::load and to the continuum's forces, with energies and
/// ledger entries. dt: s, last step, 0 at the start. Requires: redistributed vertices and particles, and
/// ghosts of the continuum if the two touch. Collective.
void loadSheets(const SheetView& view, Halos halos, PhaseTimes& times, double dt);

/// Second part: updates velocities with the forces at the new positions, then temperatures.
void kickSheets(const SheetView& view, double dt);

/// Returns the longest stable step (s) of this rank's vertices; `never` if all steps are stable. The caller
/// reduces it over ranks.
double sheetStepLimit(const SheetBodies& sheets, const Scene& scene, const Clock& clock);

}  // namespace thaw
