// Solids at rest sleep: what has been calm for a while, with all that is around it, is held where it is, and
// its sums over neighbours and bonds are not formed again. Off unless the scene asks for it
// (numerics.sleep_speed).
//
// A particle is calm in a step in which it is solid, slower than sleep_speed, accelerates by less than
// sleep_speed / sleep_after and warms by less than sleep_heating; Continuum::calm is for how long. Where
// everything in the 27 cells around has been calm for sleep_after, it falls asleep:
//   1  its velocity is taken (booked as dissipated); place and temperature are held from now on, forces are
//   still found and can wake it 2  forces were found with everything at its final place and velocity 3  the
//   same with all in the 27 cells at least at 2: nothing that enters its sums changes any more. If all in the
//   27 cells are at 3, its cell
//      is skipped: what a step would find is what is there already, the stress at the other ends of its bonds
//      included. Passes leave its rows out (awakeRows), what holds it is booked by a sum that is kept, and
//      where all cells around are skipped, too, nobody asks for its records (rowsToSee).
// Whatever is not calm wakes all cells around it within a step, which is faster than any wave (a cell is at
// least a support radius wide). Since what is skipped would give the same bits, who is skipped may depend on
// the rank (after a migration nothing is known, so all is found anew), while who sleeps, and the force that
// holds it, follow from State columns alone: in the step in which something two cells away wakes, what is
// found anew differs.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/math/exact_sum.hpp"
#include "core/particles/continuum.hpp"
#include "core/particles/row_span.hpp"

namespace thaw {

struct World;
struct StepTools;

/// values of Continuum::sleep
inline constexpr std::uint8_t awake = 0, heldNow = 1, heldBefore = 2, asleep = 3;

/// Of the step; not part of the state.
struct SleepWork {
  bool findAll = true;  ///< what sleeps has not been found on this rank since the start, a restart, or its
                        ///< arrival
  std::vector<std::uint8_t> cell;          ///< by cell: bits of what all its particles are
  std::vector<std::uint8_t> around;        ///< the same of the 27 cells around
  std::vector<std::uint8_t> known, quiet;  ///< by cell: it is skipped; all 27 around are
  std::vector<RowSpan> rows;               ///< owned ones that are not skipped, and little more
  std::vector<RowSpan> seen;  ///< those in the 27 cells around one that is not skipped, and little more
  std::vector<std::uint64_t> deepCells, deepBefore;  ///< keys of those with rows that are deep, in this step
                                                     ///< and in the last
  std::array<ExactSum, 3> deepHold;   ///< N, sum of Continuum::hold over the rows of deepBefore
  std::vector<std::uint8_t> deep;     ///< by owned row: sleeps so that nothing in its sums changes
  std::vector<std::uint8_t> skipped;  ///< by owned row: deep, and known here
  std::vector<double> interaction;    ///< J, by owned row, as the last step left it
  std::vector<std::uint8_t> fresh;    ///< by slot: deformation and flux are of the place where it sleeps
  std::vector<double> stretch2;       ///< by group of slots: its largest square of a stretch
};

/// After contacts with walls are known, and before rates are cleared and ghosts are sent: keeps
/// SleepWork::interaction; wakes what a moving wall touches, and everything where a wall vanishes or a
/// tempering acts in the step that ends now. dt: s, of that step.
void beginSleep(World& world, StepTools& tools, double dt);

/// Nothing sleeps, or has been calm, any more: other coefficients are other forces, and what was found of
/// sleepers is of the old ones.
void wakeEverything(Continuum& particles);

/// Before ghosts are there: marks inner cells that are skipped in StepTools::inner.
void markAsleep(World& world, StepTools& tools);
/// With the ghosts: marks all cells that are skipped, and rows in SleepWork.
void markAllAsleep(World& world, StepTools& tools);

/// Owned rows that passes over particles have to visit, ascending: all, or those that are not skipped. From
/// markAllAsleep to the next step's drift.
std::span<const RowSpan> awakeRows(const World& world, StepTools& tools);
/// Owned rows whose places and velocities somebody will read who looks at the 27 cells around him. From
/// markAsleep on.
std::span<const RowSpan> rowsToSee(const World& world, StepTools& tools);

/// Takes the contacts with walls of skipped rows off the list.
void dropSkippedContacts(StepTools& tools);

/// Before deformations: which groups of slots are worked on. After a relink, which says which slots changed:
/// forgetSlots.
void chooseAwakeGroups(World& world, StepTools& tools);
void forgetChangedSlots(const World& world, StepTools& tools);

/// Continuum::hold of what is held, before walls act.
void noteHolds(World& world, const StepTools& tools);

/// When all forces of the step are known: who is calm, falls asleep, wakes. Books what holding takes. dt: s,
/// of the step.
void settleSleep(World& world, StepTools& tools, double dt);

}  // namespace thaw
