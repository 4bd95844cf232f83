// How far a run is: a line for the terminal, and all books for OUT/progress.csv, which any program reads.
#pragma once
#include <map>
#include <string>

#include "core/ledger/report.hpp"
#include "core/time/clock.hpp"
#include "io/run/summary.hpp"

namespace thaw {

struct Progress {
  Clock clock;
  double stepsPerSecond = 0, secondsLeft = 0;
};

/// "t 0.48187 s  step 6033  dt 8.0e-05 s (elastic waves)  43.4 steps/s  left 12 min 6 s  particles 20106
/// liquid 9.2 %  residual +6.9e-04 J (+9.4e-04)": the energy that no term of the ledger explains, and its
/// share of the largest term. Behind it what solvers and the surface add. Some 160 characters.
std::string progressLine(const Progress& progress, const LedgerReport& ledger);
/// "  density 7 it  viscosity 12 it", of the last step.
std::string progressOf(const std::vector<SolverUse>& solvers);
/// "  surfels 60123"; empty without a surface.
std::string progressOf(const SurfaceSummary& surface);

std::string progressLogPath(const std::string& out);
/// A new log, with its head. One process only, as are the next two; IoError where the disk says no.
void beginProgressLog(const std::string& out);
/// One line: clock, books, solvers, surface.
void addToProgressLog(const std::string& out, const Progress& progress, const RunSummary& summary);
/// The last whole line of the log, by column; empty where there is none.
std::map<std::string, std::string> lastProgress(const std::string& out);
/// Drops lines of after `step`, and one that was not finished, of a run that goes back, or on from a
/// checkpoint; a log that is not there, or has other columns, begins anew.
void cutProgressLog(const std::string& out, std::int64_t step);

}  // namespace thaw
