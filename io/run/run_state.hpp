// A run in progress: the world, its halos, and what is written of it. All functions are collective.
#pragma once
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <memory>
#include <set>
#include <utility>

#include "core/kinds/kinds.hpp"
#include "core/setup/setup.hpp"
#include "core/surface/update_surface.hpp"
#include "core/watch/good_state.hpp"
#include "io/commands/run.hpp"
#include "io/output/checkpoint.hpp"
#include "io/output/series.hpp"
#include "io/run/profile.hpp"
#include "io/run/signals.hpp"
#include "io/run/summary.hpp"
#include "parallel/bond_halo.hpp"
#include "parallel/cell_halo.hpp"
#include "parallel/row_courier.hpp"

namespace thaw {

using WallClock = std::chrono::steady_clock;
inline double since(WallClock::time_point t) {
  return std::chrono::duration<double>(WallClock::now() - t).count();
}

/// What a run holds beside the world.
struct Run {
  const RunOptions& options;
  const Communicator& comm;
  World world;
  StepTools tools;
  MpiReducer all;
  std::unique_ptr<MpiCellHalo> cells;
  std::unique_ptr<MpiBondHalo> bonds;
  std::unique_ptr<SurfaceRanks> surface;                       // where the scene has one; as are the next two
  std::array<std::unique_ptr<MpiCellHalo>, kindCount> kinds;   // of the further kinds that the scene has
  std::unique_ptr<MpiBondHalo> edges;                          // of the sheets
  std::array<std::vector<SeriesEntry>, kindCount> kindSeries;  // rank 0
  SurfaceTools surfaceTools;
  std::vector<SeriesEntry> surfaceSeries;  // rank 0
  std::string name;                        // of the scene, for its files
  std::vector<SeriesEntry> series;         // rank 0
  RunSummary summary;
  WallClock::time_point start = WallClock::now(), lastReport = start, lastCheckpoint = start;
  std::int64_t firstStep = 0, stepAtReport = 0;
  GoodState good;      // the last one
  LedgerReport books;  // of the state that is about to become it
  bool goodInMemory = false, goodOnDisk = false;
  std::unique_ptr<Profile> profile;  // with --profile, from the first step on
  bool resumed = false;              // it goes on from a checkpoint
  bool begun = false;                // the world holds its particles
  bool cutAtStart = false;  // stopped in the relaxation before the start: nothing of the run is there
  std::set<std::pair<std::size_t, std::size_t>> sunkenTold;  // oriented bodies and bodies that warnOfSunken
                                                             // has told of
  std::set<std::pair<std::size_t, std::size_t>> inObstaclesTold;  // the same of oriented bodies and walls
  bool stepping = false;  // in the loop, where ranks wait for each other

  Run(const RunOptions& o, const Communicator& c) : options(o), comm(c), all(c) {}
  Halos halos() {
    return {all, *cells, *bonds, {kinds[orientedKind].get(), kinds[sheetKind].get()}, edges.get()};
  }
  bool first() const { return comm.rank() == 0; }
  /// To the terminal and the summary, once.
  void warn(const std::string& line) {
    if (std::find(summary.warnings.begin(), summary.warnings.end(), line) != summary.warnings.end()) return;
    summary.warnings.push_back(line);
    say("warning: " + line);
  }
  void say(const std::string& line) const {
    if (first()) std::printf("%s\n", line.c_str()), std::fflush(stdout);
  }
  RunStamp stamp() const { return {name, world.scene.text, world.scene.output.piecesByRank}; }
};

/// New halos for particles, bonds and surface: at the start, and as after a restart.
void renewHalos(Run& run);

/// The next frame, of all that the scene has (a scene without continuum has none of particles), and its lines
/// in the series.
void writeFrameOf(Run& run);

/// A progress line, and one with all books in OUT/progress.csv.
void report(Run& run);

/// Warns of events and fields of oriented bodies that have met nothing.
void warnOfIdle(Run& run);

/// Warns once of each oriented body and body of which particles of the first have come into the second.
/// Between two steps, where good states are due, and at the end. Collective.
void warnOfSunken(Run& run);

/// Gathers and writes summary.json.
void summarise(Run& run, const std::string& status, const std::string& message);

/// Says what --profile has found, and writes OUT/trace.json; once, at whatever end.
void reportProfile(Run& run);

/// With it a summary, so that also a run that is killed leaves one.
void writeCheckpointOf(Run& run);

/// What ends a run from outside, as this rank sees it: rank 0 has the clock and the look at the disk for all.
StopWatch stopWatchOf(const Run& run);

/// A summary for a run that failed; failures of this are not reported on top. `together`: all ranks are here,
/// so that the state that they hold, if they hold one already, can be gathered.
void noteFailure(Run& run, const std::string& message, bool together);

/// The same for a run that was stopped before it began.
void noteCutAtStart(Run& run, const std::string& message);

/// Samples the scene's bodies, or goes on from the newest checkpoint; or sets Run::cutAtStart. Throws
/// SceneErrors, IoError.
void begin(Run& run, const MeshLoader& load);

}  // namespace thaw
