// SPDX-License-Identifier: Apache-2.0
// OUT/ledger.csv: all terms of the ledger. It has a row for the start, each frame, each `output.ledger_every`
// of simulated time, and the end. Its bytes do not depend on ranks, restarts and retries.
#pragma once
#include <string>

#include "io/run/run_state.hpp"

namespace thaw {

std::string ledgerLogPath(const std::string& out);

/// Starts a new log with its header: the columns of the scene's modules. First rank only. Throws IoError.
void beginLedgerLog(const std::string& out, const Modules& modules);

/// Removes rows after `step` and an incomplete last line, at a rollback or restart. Begins a new log if it is
/// missing or has other columns. First rank only. Throws IoError.
void truncateLedgerLog(const std::string& out, const Modules& modules, std::int64_t step);

/// Returns whether a row is due for the step from the time `before` (s) to the current time. Requires: the
/// frames of the current time are not written yet.
bool ledgerRowDue(const Scene& scene, const Clock& clock, double before);

/// Writes a row. Requires: forces of the current positions. Collective.
void writeLedgerRow(Run& run);

}  // namespace thaw
