// SPDX-License-Identifier: Apache-2.0
// Rollback: the snapshots of a run, and the response to failures that the stability monitor
// (core/simulation/monitor/) finds. All functions are collective.
#pragma once
#include "io/run/run_state.hpp"

namespace thaw {

/// Takes the first snapshot after a start or restart, unless the snapshot that a retry needs is on disk.
void beginRetries(Run& run);

/// Returns whether a snapshot is due: in steps that are multiples of Numerics::retryEvery. This does not
/// depend on ranks or wall-clock time.
bool snapshotDue(const Run& run);

/// Checks the ledger when a snapshot is due; acceptSnapshot then takes the snapshot. Frames may be written
/// in between.
Failure checkLedgerOf(Run& run);
void acceptSnapshot(Run& run);

/// Takes a snapshot of rows that the program has changed, so that a retry keeps the changes.
void acceptEdit(Run& run);

/// Returns whether a checkpoint needs no separate snapshot: without retries, or at the step of the last
/// snapshot. Periodic checkpoints are delayed until then.
bool atSnapshot(const Run& run);

/// Writes the last snapshot beside the checkpoint of a run that stops between two snapshots, unless it is
/// already on disk.
void writeLastSnapshot(Run& run);

/// Responds to a failure in the last step. Returns true after a rollback to the last snapshot, with half the
/// step; later frames are written again. Returns false if the retries are used up. `why` then
/// describes the failure and the retries, and the last snapshot is written as a checkpoint.
bool rollBack(Run& run, const StepOutcome& failed, std::string& why);

}  // namespace thaw
