// SPDX-License-Identifier: Apache-2.0
// Progress of a run: a line for the terminal, and all terms of the ledger for OUT/progress.csv.
#pragma once
#include <map>
#include <string>

#include "core/simulation/ledger/report.hpp"
#include "core/time/clock.hpp"
#include "io/run/reports/summary.hpp"

namespace thaw {

struct Progress {
  Clock clock;
  double stepsPerSecond = 0, secondsLeft = 0;
};

/// Returns "t 0.48187 s  step 6033  dt 8.0e-05 s (elastic waves)  43.4 steps/s  left 12 min 6 s  particles
/// 20106 liquid 9.2 %  residual +6.9e-04 J (+9.4e-04)". The residual is the energy that no term of the ledger
/// explains, with its share of the largest term. Solvers and the surface add their text behind it. The line
/// has some 160 characters.
std::string progressLine(const Progress& progress, const LedgerReport& ledger);
/// Returns "[====>       ]  left 12 min  dt 8.0e-05 s (elastic waves)  liquid 9.2 %  residual +9.4e-04", for
/// a line that is redrawn in place: at most 79 characters, with percentage and time where they fit.
std::string statusLine(const Progress& progress, const LedgerReport& ledger);
/// Returns "  density 7 it  contact 12 it (2e-06 of 3e-06 m/s)", for the last step: iterations, and the error
/// of contacts with its tolerance.
std::string progressOf(const std::vector<SolverUse>& solvers);
/// Returns "  surfels 60123", or "" without a surface.
std::string progressOf(const SurfaceSummary& surface);

std::string progressLogPath(const std::string& out);
/// Starts a new log with its header. One process only, as for the functions below. Throws IoError.
void beginProgressLog(const std::string& out);
/// Adds a line: clock, ledger, solvers, surface.
void addToProgressLog(const std::string& out, const Progress& progress, const RunSummary& summary);
/// Returns the last complete line of the log by column, or nothing.
std::map<std::string, std::string> lastProgress(const std::string& out);
/// Drops lines after `step` and an incomplete last line, at a rollback or restart. Starts a new log if it is
/// missing or has other columns.
void truncateProgressLog(const std::string& out, std::int64_t step);

}  // namespace thaw
