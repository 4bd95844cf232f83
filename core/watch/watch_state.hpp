// What the watch carries from step to step; part of the state, in every checkpoint.
#pragma once
#include <cstdint>

namespace thaw {

struct WatchState {
  double factor = 1;           ///< 1, of the step: its limits, or the fixed step, times this; grows towards
                               ///< 2^-halvings by a tenth a step
  std::int64_t halvings = 0;   ///< of the step that are in force
  std::int64_t failures = 0;   ///< retries whose halving is still in force; at most Numerics::retries
  std::int64_t patience = 1;   ///< good states that are to follow each other before the step doubles; itself
                               ///< doubled by each failure
  std::int64_t calm = 0;       ///< good states since the last failure or doubling
  std::int64_t goodStep = -1;  ///< step of the last good state; -1: there is none
  double residual = 0;         ///< J, LedgerReport::energyResidual of the last good state
  double scale = 0;            ///< J, its LedgerReport::energyScale
  double largest = 0;          ///< J, largest energyScale of all good states since the run began
  double fullStep = 0;         ///< s, step without halvings at the last good state, before frames cut it
  double passed = 0;           ///< s, simulated time from which on the latest failure counts as passed
};

}  // namespace thaw
