// SPDX-License-Identifier: Apache-2.0
// Time-dependent coefficients of sheets: their current factors, and the work of changes (DS section 3.2). The
// energy of a spring is proportional to its stiffness, so a change of stiffness is external work.
#pragma once
#include "core/ledger/ledger.hpp"
#include "core/sheet/data/sheets.hpp"
#include "core/time/clock.hpp"

namespace thaw {

/// Updates the factors to the end of a step of dt (s, 0 at the start). Call it before force evaluation.
void updateTimeFactors(SheetBodies& sheets, const Scene& scene, const Clock& clock, double dt);

/// Activates Sheets::changing if a spring, volume, repulsion or attraction changes in time.
void activateTimeFactors(SheetBodies& sheets, const Scene& scene);

/// Returns the longest step (s) from `now` (s) that resolves the changes of a sheet's coefficients, since
/// stableStep includes only the stiffness. The step ends where a change begins. During a change, it is a
/// small fraction of the change's duration and of an oscillation. The error of a midpoint coefficient is
/// (rate step)^2 / 12 of the change. swing and of: 1/s, fastest rates of the law's own motion (damping,
/// stiffness) and of forces between neighbours.
double timeFactorStepLimit(const SheetBody& body, double now, double swing, double of);

/// Returns the fastest rate (1/s) of a single vertex after a time (s).
double fastestRate(const SheetBody& body, const SpringLaw& law, double from);

/// Index range of Sheets::changing.
inline constexpr std::size_t firstEnergyFactor = placeOf(SheetFactor::Warp),
                             lastEnergyFactor = placeOf(SheetFactor::Attraction);
inline double& factorEnergyOf(Sheets& s, std::size_t i, SheetFactor f) {
  const std::size_t k = placeOf(f) - firstEnergyFactor;
  return s.changing[i].row[k / 3][static_cast<int>(k % 3)];
}

/// Records half of the work of coefficient changes between two times (s), from the current energies. Call it
/// at both ends of a step, for the trapezoidal rule.
void recordFactorWork(SheetBodies& sheets, const Scene& scene, Ledger& ledger, double from, double to);

}  // namespace thaw
