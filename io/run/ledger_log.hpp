// OUT/ledger.csv: all terms of the ledger, a row for the start, each frame, each `output.ledger_every` of
// simulated time, and the end. The same bytes on any number of ranks, and over restarts and retries.
#pragma once
#include <string>

#include "io/run/run_state.hpp"

namespace thaw {

std::string ledgerLogPath(const std::string& out);

/// A new log, with its head. First rank only; IoError.
void beginLedgerLog(const std::string& out);

/// Drops rows after `step` and a last line that is not whole: the run goes on from there. A log that is
/// missing, or has other columns, begins anew. First rank only; IoError.
void cutLedgerLog(const std::string& out, std::int64_t step);

/// Is there a row for the step that led from the time `before` (s) to now? To be asked before the frames of
/// now are written.
bool ledgerRowDue(const World& world, double before);

/// Requires: forces were evaluated at the places of now. Collective.
void writeLedgerRow(Run& run);

}  // namespace thaw
