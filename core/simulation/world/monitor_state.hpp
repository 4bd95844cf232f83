// SPDX-License-Identifier: Apache-2.0
// State of the stability monitor between steps. It is part of every checkpoint.
#pragma once
#include <cstdint>

namespace thaw {

struct MonitorState {
  double factor = 1;  ///< 1, factor of the step limit or of the fixed step; grows by a tenth per step up to
                      ///< 2^-backoff
  std::int64_t backoff = 0;            ///< number of active halvings of the step
  std::int64_t failures = 0;           ///< rollbacks whose halving is still active; at most Numerics::retries
  std::int64_t requiredSnapshots = 1;  ///< number of successive snapshots required before the step doubles;
                                       ///< each failure doubles this number
  std::int64_t snapshotsSinceChange = 0;  ///< number of snapshots since the last failure or doubling
  std::int64_t snapshotStep = -1;         ///< step of the last snapshot; -1: none
  double residual = 0;                    ///< J, LedgerReport::energyResidual of the last snapshot
  double scale = 0;                       ///< J, LedgerReport::energyScale of the last snapshot
  double largest = 0;                     ///< J, largest energyScale of all snapshots since the run began
  double fullStep = 0;  ///< s, step without backoff at the last snapshot, before frames shortened it
  double passed = 0;    ///< s, simulated time after which the latest failure counts as passed
};

}  // namespace thaw
