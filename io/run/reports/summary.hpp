// SPDX-License-Identifier: Apache-2.0
// summary.json, which a run leaves also when it fails.
#pragma once
#include <map>
#include <string>
#include <vector>

#include "core/halo/halo.hpp"
#include "core/simulation/ledger/report.hpp"
#include "core/simulation/world/world.hpp"
#include "core/time/phase_times.hpp"

#include "io/run/reports/communication_summary.hpp"
#include "io/run/reports/solver_use.hpp"
#include "io/run/reports/surface_summary.hpp"

namespace thaw {

struct RunSummary {
  std::string status = "running";  ///< "done", "stopped", "failed", "refused"
  std::string message;             ///< reason of a stop or failure
  std::string sceneFile, title;
  int ranks = 1;
  LedgerReport ledger;
  Clock clock;
  Counters counters;                         ///< sums over ranks
  std::int64_t stepsHere = 0;                ///< steps of this process, without those before a restart
  double wall = 0;                           ///< s
  double particleSteps = 0;                  ///< sum over ranks, by this process
  std::map<std::string, RankSpread> phases;  ///< s per rank
  double imbalance = 1;                      ///< largest over mean working time of ranks
  CommunicationSummary communication;        ///< communication of this process
  double peakMemory = 0;                     ///< bytes, largest over ranks
  double particleSpread = 1;                 ///< largest over mean number of particles per rank
  std::vector<std::string> warnings;
  std::vector<std::string> modules;
  std::vector<std::string> extensions;  ///< names of extensions of programs, set once
  std::vector<SolverUse> solvers;       ///< from the first rank
  SurfaceSummary surface;
};

/// Gathers phases, imbalance, bytes, memory and counters over ranks. Collective.
void gatherSummary(RunSummary& summary, const World& world, const PhaseTimes& times,
                   const CommunicationStatistics& statistics, Reducer& all);

inline constexpr const char* summaryName = "summary.json";
/// Summary of a start that is refused, in a folder that holds a run. The summary of that run stays as it is.
inline constexpr const char* refusedName = "summary.refused.json";

/// Returns the counters of all ranks together. Collective.
Counters sumOfCounters(const Counters& own, Reducer& all);

/// Writes OUT/NAME and replaces the old file at once. One process only. Throws IoError.
void writeSummary(const std::string& out, const RunSummary& summary, const std::string& name = summaryName);

/// Returns warnings with counts of corrections and anomalies.
std::vector<std::string> warningsOf(const Counters& counters, const LedgerReport& ledger);

/// Returns the peak resident memory of this process, in bytes.
double peakMemory();

}  // namespace thaw
