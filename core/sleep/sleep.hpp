// SPDX-License-Identifier: Apache-2.0
// Sleep of solids at rest. Solids that have been at rest for a while, together with their surroundings, are
// fixed in place. Their sums over neighbours and bonds are skipped. Sleep is off unless the scene sets
// numerics.sleep_speed.
//
// A solid particle is at rest in a step if it is slower than sleep_speed. It must also accelerate by less
// than sleep_speed / sleep_after, and warm by less than sleep_heating. Continuum::restTime is its rest time.
// A particle sleeps in three stages once all particles in its 27 cells have rested for sleep_after:
//   1  Its velocity is set to 0 (recorded as dissipated); position and temperature are fixed. Forces are
//      still computed and can wake it.
//   2  Forces were computed with everything at its final position and velocity.
//   3  All particles in the 27 cells are at least at stage 2, so nothing in its sums changes any more.
// If all particles in the 27 cells are at stage 3, the middle cell is skipped. All results of a skipped cell
// are those of the last step, including the stress at the other ends of its bonds. Passes skip its rows
// (awakeRows), and its constraint force enters the ledger as a cached sum. If all surrounding cells are
// skipped too, its records are not packed (visibleRows).
//
// A moving particle wakes all surrounding cells within a step. This is faster than any wave, since a cell is
// at least a support radius wide. Skipped results have the same bits as computed ones, so the set of skipped
// cells may depend on the rank. After a migration everything is recomputed. The sleep stage and the
// constraint force must not depend on the rank. When a particle two cells away wakes, recomputed values
// differ in that step. Both thus follow from State columns alone.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/math/exact_sum.hpp"
#include "core/particles/continuum.hpp"
#include "core/particles/row_span.hpp"
#include "core/particles/sleep_stage.hpp"

namespace thaw {

struct ElasticWork;
struct Modules;
struct Scene;
struct SleepView;
struct Solids;
struct WallContacts;

/// Sleep data of a step; not part of the state.
struct SleepWork {
  bool recomputeAll = true;  ///< some sleeping particles have not been computed on this rank since the start,
                             ///< a restart, or their arrival
  std::vector<std::uint8_t> cell;                        ///< by cell: bits common to its particles
  std::vector<std::uint8_t> around;                      ///< by cell: bits common to the 27 surrounding cells
  std::vector<std::uint8_t> known, surroundedBySkipped;  ///< by cell: 1 if it is skipped; 1 if all 27
                                                         ///< surrounding cells are skipped
  std::vector<RowSpan> rows;  ///< owned rows that are not skipped, with small gaps included
  std::vector<RowSpan> seen;  ///< owned rows in the 27 cells around cells that are not skipped, with small
                              ///< gaps included
  std::vector<std::uint64_t> steadyCells, steadyBefore;  ///< keys of cells with steady rows, in this step and
                                                         ///< in the last
  std::array<ExactSum, 3> steadyConstraintForce;  ///< N, sum of Continuum::constraintForce over the rows of
                                                  ///< steadyBefore
  std::vector<std::uint8_t> steady;   ///< by owned row: 1 if it sleeps and nothing in its sums changes.
                                      ///< Before markSleeping, only rows of inner cells are set
  std::vector<std::uint8_t> skipped;  ///< by owned row: 1 if steady and already computed on this rank
  std::vector<double> interaction;    ///< J, by owned row, from the last step
  std::vector<std::uint8_t> fresh;    ///< by solid: 1 if deformation and flux match the sleeping position
  std::vector<double> stretch2;       ///< by group of solids: its largest squared stretch
};

/// Stores SleepWork::interaction. Wakes particles that touch a moving wall. Wakes all if a wall vanishes or a
/// thermostat acts in the step of dt (s) that ends now. Requires: wall contacts of the step; called before
/// rates are cleared and ghosts are sent.
void beginSleep(const SleepView& view, double dt);

/// Wakes all particles and resets their rest time. Changed coefficients change forces, which makes results of
/// sleeping particles invalid.
void wakeEverything(Continuum& particles);

/// Marks skipped inner cells in SleepView::inner, before ghosts arrive.
void markSleepingInner(const SleepView& view);
/// Marks all skipped cells, and the rows in SleepWork. Requires: ghosts.
void markSleeping(const SleepView& view);

/// Returns the owned rows that passes over particles have to visit, ascending: all rows, or those that are
/// not skipped. Valid from markSleeping to the drift of the next step.
std::span<const RowSpan> awakeRows(const Modules& modules, const Continuum& particles, SleepWork& sleep);
/// Returns the owned rows whose positions and velocities are read by sums of rows in the 27 surrounding
/// cells. Valid from markSleepingInner on.
std::span<const RowSpan> visibleRows(const Modules& modules, const Continuum& particles, SleepWork& sleep);

/// Removes wall contacts of skipped rows from the list.
void dropSkippedContacts(const SleepWork& sleep, WallContacts& contacts);

/// chooseAwakeGroups selects the active groups of solids; call it before deformations. forgetChangedSolids
/// resets the solids that a bond update changed; call it after rebuildBonds.
void chooseAwakeGroups(const Continuum& particles, const Solids& solids, ElasticWork& elastic,
                       SleepWork& sleep);
void forgetChangedSolids(const Solids& solids, SleepWork& sleep);

/// Sets Continuum::constraintForce of sleeping particles, before wall forces are added.
void recordConstraintForces(Continuum& particles, const Scene& scene, const SleepWork& sleep);

/// Updates rest times and sleep stages from all forces of a step of dt (s). Records the energy that
/// constraints remove.
void updateSleep(const SleepView& view, double dt);

}  // namespace thaw
