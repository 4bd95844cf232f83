// SPDX-License-Identifier: Apache-2.0
// A run in progress: the world, its halos and its output. All functions are collective.
#pragma once
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <memory>
#include <set>
#include <utility>

#include "core/simulation/monitor/snapshot.hpp"
#include "core/surface/update_surface.hpp"
#include "io/checkpoint/checkpoint.hpp"
#include "io/frames/series.hpp"
#include "io/run/ledger_history.hpp"
#include "io/run/reports/profile.hpp"
#include "io/run/reports/summary.hpp"
#include "io/run/run_options.hpp"
#include "io/run/signals.hpp"
#include "parallel/mpi_simulation.hpp"
#include "parallel/row_scatter.hpp"

namespace thaw {

using WallClock = std::chrono::steady_clock;
inline double since(WallClock::time_point t) {
  return std::chrono::duration<double>(WallClock::now() - t).count();
}

/// A simulation with the state of its output.
struct Run : MpiSimulation {
  const RunOptions& options;
  const Communicator& comm;
  std::unique_ptr<SurfaceRanks> surface;                               // only if the scene has one
  std::array<std::vector<SeriesEntry>, bodyTypeCount> bodyTypeSeries;  // rank 0
  SurfaceTools surfaceTools;
  std::vector<SeriesEntry> surfaceSeries;  // rank 0
  std::string name;                        // name of the scene, for file names
  std::vector<SeriesEntry> series;         // rank 0
  RunSummary summary;
  std::vector<std::string> countedWarnings;    // about counters, ledger and surface at the last report
  std::vector<std::string> publishedWarnings;  // content of OUT/warnings.json
  WallClock::time_point startedAt = WallClock::now(), lastReport = startedAt, lastCheckpoint = startedAt;
  std::int64_t firstStep = 0, stepAtReport = 0;
  WorldSnapshot good;           // the last snapshot
  LedgerReport snapshotLedger;  // ledger of the next snapshot
  bool snapshotInMemory = false, snapshotOnDisk = false;
  std::unique_ptr<Profile> profile;  // with --profile, from the first step on
  bool resumed = false;              // the run continues from a checkpoint
  bool begun = false;                // the world holds its particles
  bool stoppedInRelaxation = false;  // stopped during relaxation before the start: nothing of the run is on
                                     // disk
  std::set<std::pair<std::size_t, std::size_t>> interpenetrationWarned;  // pairs of oriented body and body,
                                                                         // after a warning
  std::set<std::pair<std::size_t, std::size_t>> obstacleInterpenetrationWarned;  // the same for walls
  std::vector<std::function<void()>> onStep, onFrame;  // functions of the program, called after each step
                                                       // and each frame
  bool stepping = false;                               // in the step loop, whose calls are collective
  bool advancing = false;                              // within advance()
  bool edited = false;                     // rows changed by the program are not yet in a snapshot
  std::unique_ptr<LedgerHistory> history;  // with RunOptions::history

  Run(const RunOptions& o, const Communicator& c) : MpiSimulation(c), options(o), comm(c) {}
  bool first() const { return comm.rank() == 0; }
  /// Prints a warning and adds it to the summary and to OUT/warnings.json, once.
  void warn(const std::string& line) {
    if (std::find(summary.warnings.begin(), summary.warnings.end(), line) != summary.warnings.end()) return;
    summary.warnings.push_back(line);
    say("warning: " + line);
    publishWarnings();
  }
  /// Returns the warnings of the summary and those of counters and ledger.
  std::vector<std::string> allWarnings() const;
  /// Writes OUT/warnings.json if the warnings have changed. Not collective: the first rank writes.
  void publishWarnings();
  void say(const std::string& line) const {
    if (first() && options.log) options.log(line);
  }
  bool writes() const { return !options.out.empty(); }
  RunStamp stamp() const;
};

/// Runs `work` on the first rank if the run has a folder. Throws its IoError on all ranks. Collective.
void onDisk(const Run& run, const std::function<void()>& work);

/// Makes new halos for the surface, at the start and at a rollback.
void renewSurfaceHalos(Run& run);

/// Writes the next frame of each part of the scene, and its lines in the indices. A scene without continuum
/// has no frame of particles.
void writeFrameOf(Run& run);

/// Prints a progress line and adds one with the whole ledger to OUT/progress.csv.
void report(Run& run);

/// Warns of events and fields of oriented bodies that affect no particle.
void warnOfUnused(Run& run);

/// Warns of interpenetration, once for each oriented body and body or obstacle. Called when snapshots are due
/// and at the end. Collective.
void warnOfInterpenetration(Run& run);

/// Gathers and writes summary.json.
void summarise(Run& run, const std::string& status, const std::string& message);

/// Prints the profile and writes OUT/trace.json. Call it once, however the run ends.
void reportProfile(Run& run);

/// Writes a checkpoint and a summary. Killed runs thus leave a summary, too.
void writeCheckpointOf(Run& run);

/// Returns the monitor of stop requests on this rank. Rank 0 checks clock and disk for all.
StopMonitor stopMonitorOf(const Run& run);

/// Writes the summary of a failed run; ignores errors in doing so. together: all ranks call it, so their
/// state can be gathered, if there is one.
void summariseFailure(Run& run, const std::string& message, bool together);

/// Writes the summary of a run that was stopped before its start.
void summariseStoppedRelaxation(Run& run, const std::string& message);

/// Samples the bodies of the scene, continues from the newest checkpoint, or sets Run::stoppedInRelaxation.
/// Throws SceneErrors, IoError.
void begin(Run& run, const MeshLoader& load);

}  // namespace thaw
