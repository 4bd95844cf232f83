#include "io/commands/run.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "core/geometry/shape_error.hpp"
#include "core/setup/setup.hpp"
#include "core/time/limits.hpp"
#include "io/commands/require_memory.hpp"
#include "io/commands/scene_for_all.hpp"
#include "io/hdf5/agree.hpp"
#include "io/output/checkpoint.hpp"
#include "io/output/frame_fields.hpp"
#include "io/output/series.hpp"
#include "io/run/scene_marks.hpp"
#include "io/run/signals.hpp"
#include "io/run/summary.hpp"
#include "io/scene/read_scene.hpp"
#include "parallel/balance.hpp"
#include "parallel/bond_halo.hpp"
#include "parallel/cell_halo.hpp"

namespace thaw {
namespace {

using WallClock = std::chrono::steady_clock;
double since(WallClock::time_point t) { return std::chrono::duration<double>(WallClock::now() - t).count(); }

/// What a run holds beside the world.
struct Run {
  const RunOptions& options;
  const Communicator& comm;
  World world;
  StepTools tools;
  MpiReducer all;
  std::unique_ptr<MpiCellHalo> cells;
  std::unique_ptr<MpiBondHalo> bonds;
  std::string name;                      // of the scene, for its files
  std::vector<SeriesEntry> series;       // rank 0
  RunSummary summary;
  WallClock::time_point start = WallClock::now(), lastReport = start, lastCheckpoint = start;
  std::int64_t firstStep = 0, stepAtReport = 0;
  bool begun = false;                    // the world holds its particles
  bool stepping = false;                 // in the loop, where ranks wait for each other

  Run(const RunOptions& o, const Communicator& c) : options(o), comm(c), all(c) {}
  Halos halos() { return {all, *cells, *bonds}; }
  bool first() const { return comm.rank() == 0; }
  void say(const std::string& line) const {
    if (first()) std::printf("%s\n", line.c_str()), std::fflush(stdout);
  }
  RunStamp stamp() const { return {name, world.scene.text, world.scene.output.piecesByRank}; }
};

void writeFrameOf(Run& r) {
  World& w = r.world;
  r.tools.times.start();
  if (w.modules.solid && std::find(w.scene.output.fields.begin(), w.scene.output.fields.end(), "stress") != w.scene.output.fields.end())
    computeCauchyStress(r.tools.elastic, w.solids);
  const WorldFrame f = frameOf(w, r.comm.rank());
  const std::string file = frameName(r.name, w.clock.frame);
  writeFrame(frameFolder(r.options.out) + "/" + file, r.comm.handle(), f.frame, r.stamp());
  onFirstRank(r.comm.handle(), [&] {
    r.series.push_back({file, w.clock.time});
    writeSeries(seriesPath(r.options.out, r.name), r.series);
  });
  w.clock.frame++;
  r.tools.times.lap(StepPhase::Frames);
}


void report(Run& r) {
  const LedgerReport l = reportLedger(r.world, r.all);
  const double rate = static_cast<double>(r.world.clock.step - r.stepAtReport) / std::max(1e-9, since(r.lastReport));
  double left = (r.world.clock.end - r.world.clock.time) / std::max(1e-300, r.world.clock.dt);
  if (r.options.steps >= 0) left = std::min(left, static_cast<double>(r.options.steps - r.world.clock.step));
  r.say(progressLine(r.world.clock, l, rate, left / std::max(1e-9, rate)));
  r.lastReport = WallClock::now();
  r.stepAtReport = r.world.clock.step;
  r.summary.ledger = l;
}

/// Gathers and writes summary.json. Collective.
void summarise(Run& r, const std::string& status, const std::string& message) {
  RunSummary& s = r.summary;
  s.status = status;
  s.message = message;
  s.ledger = reportLedger(r.world, r.all);
  s.wall = since(r.start);
  s.stepsHere = r.world.clock.step - r.firstStep;
  s.particleSteps = static_cast<double>(s.ledger.particles) * static_cast<double>(s.stepsHere);
  const std::int64_t messages = r.cells->traffic().messages + r.bonds->traffic().messages, bytes = r.cells->traffic().bytes + r.bonds->traffic().bytes;
  gatherSummary(s, r.world, r.tools.times, messages, bytes, r.all);
  onFirstRank(r.comm.handle(), [&] {
    RunSummary all = s;
    for (const std::string& w : warningsOf(s.counters)) all.warnings.push_back(w);
    writeSummary(r.options.out, all);
  });
}

/// With it a summary, so that also a run that is killed leaves one.
void writeCheckpointOf(Run& r) {
  r.tools.times.start();
  writeCheckpoint(r.options.out, r.comm.handle(), r.world, r.stamp(), sceneMarks(r.world.scene));
  r.lastCheckpoint = WallClock::now();
  r.tools.times.lap(StepPhase::Checkpoint);
  summarise(r, "running", "");
}

/// A summary for a run that failed; failures of this are not reported on top. `together`: all ranks are here, so that the state that they
/// hold, if they hold one already, can be gathered.
void noteFailure(Run& r, const std::string& message, bool together) {
  try {
    if (together && r.begun) return summarise(r, "failed", message);
  } catch (const std::exception&) {
    return;
  }
  if (!r.first()) return;
  r.summary.status = "failed";
  r.summary.message = message;
  r.summary.ranks = r.comm.size();
  r.summary.sceneFile = r.options.scene;
  r.summary.clock = r.world.clock;
  std::error_code code;
  std::filesystem::create_directories(r.options.out, code);
  try {
    writeSummary(r.options.out, r.summary);
  } catch (const std::exception&) {
  }
}

void begin(Run& r, const MeshLoader& load) {
  World& w = r.world;
  const auto slice = r.options.restart || r.options.resume ? readNewestCheckpoint(r.options.out, r.comm.handle()) : nullptr;
  if (r.options.restart && !slice) throw SceneErrors({r.options.out + ": error: --restart needs a checkpoint in its folder checkpoint/, and there is none"});
  if (slice) {
    for (const std::string& warning : slice->warnings) {
      r.say("warning: " + warning);
      r.summary.warnings.push_back(warning);
    }
    if (const std::vector<std::string> differences = sceneDifferences(slice->header.values, w.scene); !differences.empty()) {
      std::vector<std::string> lines{fmt::format("{}: error: the run in {} cannot be continued with this scene, it began with another:", r.options.scene, r.options.out)};
      for (const std::string& d : differences) lines.push_back("  " + d);
      throw SceneErrors(lines);
    }
    std::vector<std::byte> records = restoreWorld(w, *slice, r.first());
    if (w.modules.solid) r.bonds->adopt(std::move(records));
    resumeWorld(w, r.halos(), r.tools);
    w.clock.limitedBy = "the last run";
    if (r.first()) r.series = framesPresent(r.options.out, r.name, w.clock.time);
    r.say(fmt::format("continues at t {:.6g} s, step {}, from {}", w.clock.time, w.clock.step, slice->header.path));
  } else {
    const SamplingReport sampled = startWorld(w, r.halos(), r.tools, load);
    for (std::size_t b = 0; b < w.scene.bodies.size(); b++) r.say(fmt::format("body '{}': {} particles", w.scene.bodies[b].name, sampled.particles[b]));
    if (sampled.overlapping > 0) {
      const std::string line = fmt::format("{} samples lie in two bodies (first: {}), {} of them left out", sampled.overlapping, sampled.firstOverlap, sampled.removed);
      r.say("warning: " + line);
      r.summary.warnings.push_back(line);
    }
    // not before the new run is known to start: a mistake in the scene costs nothing of the run that was here
    onFirstRank(r.comm.handle(), [&] {
      clearFrames(r.options.out, r.name);
      clearCheckpoints(r.options.out);
    });
    r.begun = true;
    writeFrameOf(r);
  }
  r.begun = true;
  r.firstStep = r.stepAtReport = w.clock.step;
}

/// The step loop. Returns the exit code; `why` says what ended it.
int loop(Run& r, std::string& why) {
  World& w = r.world;
  StopWatch watch;
  if (r.first()) {  // one clock and one look at the disk for all
    watch.stopFile = r.options.out + "/stop";
    watch.timeLimit = r.options.timeLimit;
    watch.start = r.start;
  }
  WorkMeter meter;
  while (w.clock.time < w.clock.end && (r.options.steps < 0 || w.clock.step < r.options.steps)) {
    Requests wanted;
    const std::string reason = watch.reason();
    wanted.stop = !reason.empty();
    wanted.report = r.first() && since(r.lastReport) >= r.options.reportEvery;
    wanted.checkpoint = r.first() && since(r.lastCheckpoint) >= w.scene.output.checkpoint;
    const StepOutcome o = step(w, r.halos(), r.tools, wanted);
    if (!o.finite) {
      double lowest = o.badHere ? -r.comm.rank() : -never;
      r.all.maximum({&lowest, 1});
      if (o.badHere && lowest == -r.comm.rank()) {
        const Vec3d &x = w.particles.position[o.bad], &f = w.particles.force[o.bad];
        std::fprintf(stderr, "error: the simulation blew up at step %lld, t %.9g s: particle %llu of source %u at (%g, %g, %g) m has a force of (%g, %g, %g) N\n",
                     static_cast<long long>(w.clock.step), w.clock.time, static_cast<unsigned long long>(w.particles.id[o.bad]), static_cast<unsigned>(w.particles.body[o.bad]), x.x, x.y, x.z,
                     f.x, f.y, f.z);
      }
      why = fmt::format("blew up at step {}, t {:.9g} s; the last checkpoint is from before", w.clock.step, w.clock.time);
      return exitBlewUp;
    }
    while (frameDue(w.clock)) writeFrameOf(r);
    if (o.wanted.report) report(r);
    if (o.wanted.stop) {
      why = reason.empty() ? "a signal to another rank" : reason;
      return exitStopped;
    }
    if (o.wanted.checkpoint) writeCheckpointOf(r);
    if (w.clock.step % 25 == 0) {
      r.tools.times.start();
      balance(w, *r.cells, r.tools, meter);
      r.tools.times.lap(StepPhase::Balance);
    }
  }
  return exitDone;
}

int simulate(Run& r) {
  const MeshLoader load = meshLoader();
  r.world.scene = sceneForAll(r.comm, r.options.scene, r.options.overrides);
  r.name = std::filesystem::path(r.options.scene).stem().string();
  onFirstRank(r.comm.handle(), [&] {
    makeOutputFolders(r.options.out);
    std::error_code code;
    std::filesystem::remove(r.options.out + "/stop", code);  // of the run before
  });
  prepareWorld(r.world, r.tools, load);
  requireMemory(r.comm, r.world, load);
  r.cells = std::make_unique<MpiCellHalo>(r.comm, r.world.grid);
  r.bonds = std::make_unique<MpiBondHalo>(r.comm);
  const char* launched = std::getenv("OMPI_COMM_WORLD_SIZE");
  if (launched && std::atoi(launched) != r.comm.size()) {
    r.summary.warnings.push_back(fmt::format("the launcher started {} processes but MPI sees {}: launcher and library do not match", launched, r.comm.size()));
    r.say("warning: " + r.summary.warnings.back());
  }
  r.say(fmt::format("{}: {}", r.options.scene, r.world.scene.title));
  for (const std::string& why : r.world.modules.why) r.say("  " + why);
  begin(r, load);
  report(r);
  summarise(r, "running", "");
  std::string why;
  r.stepping = true;
  const int code = loop(r, why);
  if (code == exitDone || code == exitStopped) {
    report(r);
    writeCheckpointOf(r);
  }
  summarise(r, code == exitDone ? "done" : code == exitStopped ? "stopped" : "failed", why);
  for (const std::string& w : warningsOf(r.summary.counters)) r.summary.warnings.push_back(w);
  r.say(fmt::format("{} at t {:.6g} s, step {}{}; {:.3g} M particle-steps/s with {} ranks, {:.1f} s", r.summary.status, r.world.clock.time, r.world.clock.step, why.empty() ? "" : " (" + why + ")",
                    r.summary.particleSteps / r.summary.wall / 1e6, r.comm.size(), r.summary.wall));
  for (const std::string& w : r.summary.warnings) r.say("warning: " + w);
  return code;
}

/// CLI11's own message for this names the largest double.
CLI::Validator notBelowZero() {
  return {[](std::string& text) {
            char* end = nullptr;
            const double v = std::strtod(text.c_str(), &end);
            return *end == 0 && v >= 0 && v < never ? std::string() : "must be a number of at least 0, got " + text;
          },
          "", ""};
}

}  // namespace

void addRunOptions(CLI::App& c, RunOptions& o) {
  c.add_option("scene", o.scene, "scene file (TOML)")->required();
  c.add_option("--out", o.out, "folder for frames, checkpoints and the summary (default: out/<scene>)");
  c.add_option("--set", o.overrides, "key=value in place of what the scene says; may be given several times")->allow_extra_args(false);
  c.add_option("--steps", o.steps, "stop when this many steps are done in all")->check(notBelowZero());
  c.add_option("--time-limit", o.timeLimit, "stop, with a checkpoint, after this many seconds of wall-clock time")->check(CLI::PositiveNumber);
  c.add_option("--progress", o.reportEvery, "seconds between progress lines")->check(notBelowZero());
  auto* restart = c.add_flag("--restart", o.restart, "continue from the last checkpoint in --out");
  c.add_flag("--resume", o.resume, "continue if there is a checkpoint in --out, else begin")->excludes(restart);
}

int runCommand(const RunOptions& given) {
  RunOptions options = given;
  if (options.out.empty()) options.out = "out/" + std::filesystem::path(options.scene).stem().string();
  catchSignals();
  const Communicator comm;
  Run run(options, comm);
  const auto failed = [&](const std::string& message, int code) {
    if (run.first()) std::fprintf(stderr, "%s\n", message.c_str());
    noteFailure(run, message, true);
    return code;
  };
  try {
    return simulate(run);
  } catch (const SceneErrors& e) {
    return failed(e.what(), exitUsage);
  } catch (const ShapeError& e) {
    return failed(e.what(), exitUsage);
  } catch (const IoError& e) {
    return failed(std::string("error: ") + e.what(), exitInputOutput);
  } catch (const std::exception& e) {
    // set-up throws alike on all ranks; in the loop the others may be waiting: memory, a broken invariant
    const bool alike = !run.stepping && dynamic_cast<const std::runtime_error*>(&e) != nullptr;
    if (alike) return failed(options.scene + ": error: " + e.what(), exitUsage);
    noteFailure(run, e.what(), false);
    std::fprintf(stderr, "error: rank %d: %s\n", comm.rank(), e.what());
    MPI_Abort(comm.handle(), 1);
    return 1;
  }
}

}  // namespace thaw
