// What a run leaves behind as summary.json, also when it fails.
#pragma once
#include <map>
#include <string>
#include <vector>

#include "core/halo/halo.hpp"
#include "core/ledger/report.hpp"
#include "core/time/phase_times.hpp"
#include "core/world.hpp"

#include "io/run/solver_use.hpp"
#include "io/run/surface_summary.hpp"
#include "io/run/traffic_summary.hpp"

namespace thaw {

struct RunSummary {
  std::string status = "running";  ///< "done", "stopped", "failed"
  std::string message;             ///< why it stopped or failed
  std::string sceneFile, title;
  int ranks = 1;
  LedgerReport ledger;
  Clock clock;
  Counters counters;                         ///< of all ranks
  std::int64_t stepsHere = 0;                ///< done by this process, without those before a restart
  double wall = 0;                           ///< s
  double particleSteps = 0;                  ///< of all ranks, by this process
  std::map<std::string, RankSpread> phases;  ///< s a rank
  double imbalance = 1;                      ///< largest over mean time of work, over ranks
  TrafficSummary traffic;                    ///< of this process
  double peakMemory = 0;                     ///< bytes, largest of a rank
  double particleSpread = 1;                 ///< largest over mean number of particles of a rank
  std::vector<std::string> warnings;
  std::vector<std::string> modules;
  std::vector<SolverUse> solvers;  ///< of the first rank
  SurfaceSummary surface;
};

/// Fills in what has to be gathered from all ranks: phases, imbalance, bytes, memory, counters. Collective.
void gatherSummary(RunSummary& summary, const World& world, const PhaseTimes& times, const Traffic& traffic,
                   Reducer& all);

inline constexpr const char* summaryName = "summary.json";
/// Where a start that is refused says why, in a folder that holds a run: the summary of that run stays as it
/// is.
inline constexpr const char* refusedName = "summary.refused.json";

/// Writes OUT/NAME by rename; IoError. One process only.
void writeSummary(const std::string& out, const RunSummary& summary, const std::string& name = summaryName);

/// Warnings with counts, in words, of what was mended or looks wrong.
std::vector<std::string> warningsOf(const Counters& counters, const LedgerReport& ledger);

/// Peak resident memory of this process, in bytes.
double peakMemory();

}  // namespace thaw
