// Is what is being simulated still a simulation? In every step the watch looks at values that the vote has
// reduced anyway; at every good state (good_state.hpp) also at the books and at what is inside out.
#pragma once
#include <cstdint>

#include "core/fluid/liquid_materials.hpp"
#include "core/ledger/report.hpp"
#include "core/time/limits.hpp"
#include "core/world.hpp"

namespace thaw {

/// What the watch has seen. NotFinite: also a particle that would pass its support radius in a step.
/// Energy: from nowhere, since the last good state. Growth: the same since the run began, however slowly.
enum class Alarm { None, NotFinite, Speed, Density, Step, Inverted, Energy, Growth };

/// What is allowed; of the scene, so the same in every step. `never` or 0: not watched.
struct WatchBounds {
  double expected = 0;   ///< m/s, largest speed that the scene's start, gravity, emitters and obstacles make,
                         ///< or a tenth of the slowest wave's
  double speed = never;  ///< m/s
  double filling = never;   ///< 1, of a liquid
  double step = 0;          ///< s, of the shorter of the materials' limit and that of the expected speed
  double inverted = never;  ///< 1, share of the solid particles whose law does not recover
  double energy = never;    ///< 1, times the scale of the energies
};

/// The speed that is allowed is Numerics::watchSpeed times the expected speed and a tenth of the fastest
/// wave's: what is released from stress moves below that.
WatchBounds watchBounds(const Scene& scene, const Modules& modules,
                        const std::vector<LiquidMaterial>& liquids, const StepLimits& materials);

/// Largest filling of this rank's liquid particles.
double largestFilling(const World& world);

/// After the vote, from reduced values alone: limits of all ranks before Numerics::fixedStep and
/// WatchState::factor, largest filling of all ranks. The same answer on all ranks.
Alarm alarmOf(const World& world, const WatchBounds& bounds, const StepLimits& limits, double filling);

/// At what may become a good state: energy that no entry of the ledger explains, since the last good state,
/// above WatchBounds::energy times the largest of the ledger's terms then, the work of what pushes from
/// outside until now, and the kinetic energy of all mass at the expected speed; the same since the run began,
/// where the measure is the largest of the ledger's terms that there was, and at least the kinetic energy at
/// a tenth of the expected speed; and the share of solid particles with det F <= 0 whose law (Green strain
/// without a volume force) has no force that turns them back. Only energy that is too much: what is lost
/// makes no run unstable, and is in the ledger's residual. Collective.
Alarm checkBooks(const World& world, const WatchBounds& bounds, const LedgerReport& books, Reducer& all);

/// Factor of the next step, one step nearer to 2^-halvings.
double nextFactor(const WatchState& watch);

/// The world has come to a good state. The step doubles, and one retry less counts, when WatchState::patience
/// good states lie behind the latest failure and the time is past WatchState::passed.
void acceptState(World& world, const LedgerReport& books);

/// May a run whose last step failed be tried again with half the step? Not after Numerics::retries, and not
/// with a step below WatchBounds::step.
bool mayRetry(const World& world, const WatchBounds& bounds);
/// Would half the step be below WatchBounds::step?
bool retryTooShort(const World& world, const WatchBounds& bounds);

/// The world is back at the good state after `failed` was the watch of a run on from it, at the time failedAt
/// (s): halves the step, counted from the time between frames where that is shorter. The failure counts as
/// passed Numerics::retryEvery full steps behind that time.
void halveStep(World& world, const WatchState& failed, double failedAt);

}  // namespace thaw
