// SPDX-License-Identifier: Apache-2.0
#include "io/commands/run.hpp"

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <filesystem>

#include "core/domain/emit.hpp"
#include "core/fluid/density/connected_density.hpp"
#include "core/geometry/basic/shape_error.hpp"
#include "core/surface/surface_due.hpp"
#include "core/time/frame_times.hpp"
#include "io/commands/resolution_line.hpp"
#include "io/hdf5/collective_error.hpp"
#include "io/run/ledger_log.hpp"
#include "io/run/reports/progress.hpp"
#include "io/run/require_memory.hpp"
#include "io/run/retry.hpp"
#include "io/run/run_lock.hpp"
#include "io/run/run_state.hpp"
#include "io/run/signals.hpp"
#include "io/run/surface_run.hpp"
#include "io/scene/read_scene.hpp"
#include "io/scene/scene_for_all.hpp"
#include "io/scene/scene_warnings.hpp"
#include "io/text/above_zero.hpp"
#include "io/text/short_text.hpp"
#include "parallel/balance.hpp"

namespace thaw {
namespace {

/// Runs the step loop. Returns the exit code; sets `why` to the reason of a stop or failure.
int loop(Run& r, std::string& why) {
  World& w = r.world;
  StopMonitor watch = stopMonitorOf(r);
  WorkMeter meter;
  while (w.clock.time < w.clock.end && (r.options.steps < 0 || w.clock.step < r.options.steps)) {
    Requests wanted;
    const std::string reason = watch.reason();
    const double before = w.clock.time;
    wanted.stop = !reason.empty();
    wanted.report = r.first() && since(r.lastReport) >= r.options.reportEvery;
    wanted.checkpoint = r.first() && since(r.lastCheckpoint) >= w.scene.output.checkpoint;
    const auto begin = StepTrace::Clock::now();
    if (r.profile) r.profile->trace.beginStep(w.clock.step);
    StepOutcome o = step(w, r.halos(), r.tools, wanted);
    if (r.profile) r.profile->trace.add(TraceKind::Step, 0, begin, StepTrace::Clock::now());
    // The last step is checked as well, for runs shorter than retry_every.
    const bool good = snapshotDue(r), last = w.clock.time >= w.clock.end && w.scene.numerics.retryEvery > 0;
    if ((good || last) && o.failure == Failure::None) o.failure = checkLedgerOf(r);
    warnOfUnused(r);
    if (o.failure != Failure::None) {
      if (rollBack(r, o, why)) continue;
      return exitBlewUp;
    }
    if (w.modules.surface &&
        (frameDue(w.clock) || surfaceDue(w.scene, w.clock, w.grid, w.surface, o.surfaceMove2)))
      updateSurfaceOf(r);
    const bool row = ledgerRowDue(w, before);
    while (frameDue(w.clock)) writeFrameOf(r);
    if (row) writeLedgerRow(r);
    if (good || w.clock.time >= w.clock.end) warnOfInterpenetration(r);
    if (good) acceptSnapshot(r);
    if (o.wanted.report) report(r);
    if (o.wanted.stop) {
      why = reason.empty() ? "a signal to another rank" : reason;
      return exitStopped;
    }
    if (o.wanted.checkpoint && atSnapshot(r)) writeCheckpointOf(r);
    if (w.clock.step % 25 == 0) {
      r.tools.times.start();
      balance(w, *r.cells, r.tools, meter);
      r.tools.times.lap(StepPhase::Balance);
    }
  }
  return exitDone;
}

/// Warns if connected liquid has less than 0.9 of its rest density. A carried density pulls it together
/// again, unless the resolution is too coarse; a summed density does not.
void warnOfThinLiquid(Run& r) {
  constexpr double least = 0.9;
  const double density = connectedDensity(r.world.modules, r.world.particles, r.world.neighbours,
                                          r.world.counters, r.all);
  if (density >= least) return;
  const bool summed = !r.world.modules.continuity;
  const char* const keys =
      "set numerics.density = \"continuity\", numerics.tensile_limit = 1 and numerics.shifting = 0.2";
  r.warn(
      fmt::format("connected liquid has {:.2f} of its rest density on average: it is torn, or spread in a "
                  "layer of a few particles; if it should hold together, {}",
                  density, summed && !r.world.modules.solid ? keys : "choose a smaller spacing"));
}

int simulate(Run& r) {
  const MeshLoader load = meshLoader();
  r.world.scene = sceneForAll(r.comm, r.options.scene, r.options.overrides);
  if (r.options.relax > 0) {
    if (r.world.scene.oriented.empty())
      throw SceneErrors(
          {r.options.scene + ": error: there is nothing to relax: the scene has no [[oriented]]"});
    r.tools.oriented.relaxAtLeast = r.options.relax;
  }
  r.name = std::filesystem::path(r.options.scene).stem().string();
  onFirstRank(r.comm.handle(), [&] {
    makeOutputFolders(r.options.out);
    std::error_code code;
    std::filesystem::remove(r.options.out + "/stop", code);  // left by the previous run
  });
  const std::vector<std::string> slow = requireMemoryForBodyTypes(r.comm, r.world.scene, load);
  prepareWorld(r.world, r.tools, load);
  requireMemory(r.comm, r.world, r.tools.shapes);
  renewHalos(r);
  const char* launched = std::getenv("OMPI_COMM_WORLD_SIZE");
  if (launched && std::atoi(launched) != r.comm.size()) {
    r.summary.warnings.push_back(fmt::format(
        "the launcher started {} processes but MPI reports {}: launcher and MPI library do not match",
        launched, r.comm.size()));
    r.say("warning: " + r.summary.warnings.back());
  }
  r.say(fmt::format("{}: {}", r.options.scene, shortText(r.world.scene.title, longestTitle)));
  r.say("  " + resolutionLine(r.world.scene, r.options.overrides));
  for (const std::string& why : r.world.modules.why) r.say("  " + why);
  for (const std::string& line : sceneWarnings(r.world.scene)) {
    r.summary.warnings.push_back(line);
    r.say("warning: " + line);
  }
  if (!r.options.restart && !r.options.resume)
    for (const std::string& line : slow) r.say(line);
  begin(r, load);
  if (r.stoppedInRelaxation) {
    const std::string why = fmt::format(
        "stopped during relaxation before the start, after {} iterations: nothing is written, and the next "
        "run starts anew",
        r.tools.oriented.relaxed);
    summariseStoppedRelaxation(r, why);
    r.say(why);
    return exitStopped;
  }
  beginRetries(r);
  const Clock& c = r.world.clock;
  if (r.resumed && (c.time >= c.end || (r.options.steps >= 0 && c.step >= r.options.steps))) {
    r.say(fmt::format("nothing left to do: {} is reached; the folder is unchanged",
                      c.time >= c.end ? "the end of the scene" : "the number of steps"));
    return exitDone;
  }
  // Write the line of this step again, with the changes of the restart.
  if (r.resumed) onFirstRank(r.comm.handle(), [&] { truncateProgressLog(r.options.out, c.step - 1); });
  report(r);
  summarise(r, "running", "");
  std::string why;
  r.stepping = true;
  if (r.options.profile) {
    r.profile = std::make_unique<Profile>(static_cast<std::size_t>(r.options.traceSteps));
    beginProfile(*r.profile, r.tools.times, r.comm);
  }
  int code = loop(r, why);
  reportProfile(r);
  if (r.options.relax > 0) {  // relaxation alone, without steps
    const OrientedWork& o = r.tools.oriented;
    if (o.relaxStopped) code = exitStopped;
    why = fmt::format("relaxation {} after {} iterations; `thaw run --restart` continues from here",
                      o.atRest         ? "reached rest"
                      : o.relaxStopped ? "was stopped"
                      : o.relaxStalled ? "made no further progress"
                                       : "did not reach rest",
                      o.relaxed);
  } else if (code == exitDone && c.time < c.end) {
    why = "--steps is reached; --restart continues";
  }
  if (code == exitDone || code == exitStopped) {
    if (c.step != r.stepAtReport) report(r);
    writeLastSnapshot(r);
    writeCheckpointOf(r);
    warnOfThinLiquid(r);
  }
  summarise(r, code == exitDone ? "done" : code == exitStopped ? "stopped" : "failed", why);
  const std::size_t earlierWarnings = r.summary.warnings.size();
  r.say(fmt::format("{} at t {:.6g} s, step {}{}; {:.3g} M particle-steps/s with {} rank{}, {:.1f} s",
                    r.summary.status, r.world.clock.time, r.world.clock.step,
                    why.empty() ? "" : " (" + why + ")", r.summary.particleSteps / r.summary.wall / 1e6,
                    r.comm.size(), r.comm.size() == 1 ? "" : "s", r.summary.wall));
  for (const std::string& line : surfaceLines(r.summary.surface)) r.say(line);
  for (const std::string& w : warningsOf(r.summary.counters, r.summary.ledger)) r.warn(w);
  for (const std::string& w : surfaceWarnings(r.summary.surface)) r.warn(w);
  if (earlierWarnings > 0)
    r.say(fmt::format("{} warning{} above {} also in {}/summary.json", earlierWarnings,
                      earlierWarnings == 1 ? "" : "s", earlierWarnings == 1 ? "is" : "are", r.options.out));
  return code;
}

/// Accepts finite numbers of at least 0. The message of CLI11 names the largest double.
CLI::Validator notBelowZero() {
  return {[](std::string& text) {
            char* end = nullptr;
            const double v = std::strtod(text.c_str(), &end);
            return *end == 0 && v >= 0 && v < never ? std::string()
                                                    : "must be a number of at least 0, got " + text;
          },
          "", ""};
}

void addForce(CLI::App& c, RunOptions& o) {
  c.add_flag(
      "--force", o.force,
      "take over --out although a run on another host left its lock there; only if that run has ended");
}

}  // namespace

void addRunOptions(CLI::App& c, RunOptions& o) {
  c.add_option("scene", o.scene, "scene file (TOML)")->required();
  c.add_option("--out", o.out, "folder for frames, checkpoints and the summary (default: out/<scene>)");
  c.add_option("--set", o.overrides, "override a key of the scene: key=value; may be repeated")
      ->allow_extra_args(false);
  c.add_option("--steps", o.steps, "stop at this number of steps in total")->check(notBelowZero());
  c.add_option("--time-limit", o.timeLimit,
               "stop, with a checkpoint, after this many seconds of wall-clock time")
      ->check(aboveZero());
  c.add_option("--progress", o.reportEvery, "seconds between progress lines")->check(notBelowZero());
  auto* profile = c.add_flag("--profile", o.profile,
                             "print the time of each phase on all ranks, and write a trace of the last steps "
                             "to trace.json in --out");
  c.add_option("--trace-steps", o.traceSteps, "number of last steps in the trace")
      ->check(CLI::Range(1, 10000))
      ->needs(profile)
      ->capture_default_str();
  auto* restart = c.add_flag("--restart", o.restart, "continue from the last checkpoint in --out");
  c.add_flag("--resume", o.resume, "continue if there is a checkpoint in --out, else begin")
      ->excludes(restart);
  addForce(c, o);
}

void addRelaxOptions(CLI::App& c, RunOptions& o) {
  c.add_option("scene", o.scene, "scene file (TOML) with oriented bodies")->required();
  c.add_option("--out", o.out,
               "folder for the frame and a checkpoint from which `thaw run --restart` continues (default: "
               "out/<scene>)");
  c.add_option("--set", o.overrides, "override a key of the scene: key=value; may be repeated")
      ->allow_extra_args(false);
  c.add_option("--iterations", o.relax, "largest number of iterations")->check(aboveZero());
  c.add_option("--time-limit", o.timeLimit,
               "stop, with a frame and a checkpoint, after this many seconds of wall-clock time")
      ->check(aboveZero());
  c.add_option("--progress", o.reportEvery, "seconds between progress lines")->check(notBelowZero());
  addForce(c, o);
}

int runCommand(const RunOptions& given) {
  RunOptions options = given;
  if (options.out.empty()) options.out = "out/" + std::filesystem::path(options.scene).stem().string();
  catchSignals();
  const Communicator comm;
  RunLock lock;
  try {
    std::string note;
    onFirstRank(comm.handle(), [&] {
      note = lock.take({.out = options.out, .ranks = comm.size(), .force = options.force});
    });
    if (!note.empty()) std::printf("%s\n", note.c_str());
  } catch (const IoError& e) {  // another run holds the folder
    if (comm.rank() == 0) std::fprintf(stderr, "error: %s\n", e.what());
    return exitInputOutput;
  }
  Run run(options, comm);
  const auto failed = [&](const std::string& message, int code) {
    if (run.first()) std::fprintf(stderr, "%s\n", message.c_str());
    summariseFailure(run, message, true);
    return code;
  };
  try {
    return simulate(run);
  } catch (const std::exception& e) {
    if (const auto refusal = refusalOf(e)) return failed(refusal->message, refusal->code);
    // Set-up fails alike on all ranks. In the loop other ranks may be in a collective call: out of memory, a
    // broken invariant.
    const bool alike = !run.stepping && dynamic_cast<const std::runtime_error*>(&e) != nullptr;
    if (alike) return failed(options.scene + ": error: " + e.what(), exitUsage);
    summariseFailure(run, e.what(), false);
    std::fprintf(stderr, "error: rank %d: %s\n", comm.rank(), e.what());
    lock.release();
    MPI_Abort(comm.handle(), 1);
    return 1;
  }
}

}  // namespace thaw
