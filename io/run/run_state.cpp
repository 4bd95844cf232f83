// SPDX-License-Identifier: Apache-2.0
#include "io/run/run_state.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <span>

#include "core/simulation/monitor/interpenetration.hpp"
#include "core/simulation/sums/stored_energy.hpp"
#include "core/sleep/awake_reason.hpp"
#include "core/solid/elasticity/active_solids.hpp"
#include "core/surface/resume_surface.hpp"
#include "core/time/frame_times.hpp"
#include "io/frames/frame_fields.hpp"
#include "io/hdf5/collective_error.hpp"
#include "io/hdf5/io_error.hpp"
#include "io/run/body_type_run.hpp"
#include "io/run/earlier_run.hpp"
#include "io/run/ledger_log.hpp"
#include "io/run/reports/progress.hpp"
#include "io/run/reports/trace_file.hpp"
#include "io/run/reports/warning_file.hpp"
#include "io/run/restart/mesh_fingerprints.hpp"
#include "io/run/restart/restart_record.hpp"
#include "io/run/restart/validate_restart.hpp"
#include "io/run/surface_run.hpp"
#include "io/scene/read_scene.hpp"
#include "io/scene/scene_warnings.hpp"
#include "io/text/counted.hpp"

namespace thaw {

namespace {

/// Writes the summary of a run that has no state to gather.
void summariseWithoutState(Run& r, const std::string& status, const std::string& message) {
  if (!r.first() || !r.writes()) return;
  r.summary.status = status;
  r.summary.message = message;
  r.summary.ranks = r.comm.size();
  r.summary.sceneFile = r.options.scene;
  r.summary.clock = r.world.clock;
  std::error_code code;
  std::filesystem::create_directories(r.options.out, code);
  try {
    // An existing summary belongs to the run in the folder.
    writeSummary(r.options.out, r.summary, holdsRun(r.options.out) ? refusedName : summaryName);
  } catch (const std::exception&) {}
}

/// Prints the progress of relaxation, and lets stop requests end it.
void watchRelaxation(Run& r) {
  r.tools.oriented.stopRelaxing = [&r, monitor = stopMonitorOf(r),
                                   said = WallClock::now()](std::int64_t done) mutable {
    if (r.first() && done > 0 && since(said) >= r.options.reportEvery) {
      said = WallClock::now();
      r.say(
          fmt::format("oriented: iteration {} of relaxation, largest force {:.2e} of stiffness times "
                      "spacing, {} particles, {:.1f} s",
                      done, r.tools.oriented.residualForce, r.tools.oriented.relaxing, since(r.startedAt)));
    }
    return !monitor.reason().empty();
  };
}

bool interpolates(const Scene& s) {
  return std::any_of(s.oriented.begin(), s.oriented.end(),
                     [](const OrientedBody& b) { return b.growth == OrientedGrowth::Borders; });
}

/// Reports the end of relaxation. A body that is not at rest is a warning.
void reportRelaxation(Run& r) {
  const OrientedWork& o = r.tools.oriented;
  if (o.relaxed == 0 && !o.relaxStopped) return;
  const std::string line = fmt::format(
      "oriented: {} iterations of relaxation; the largest force is {:.2e} of stiffness times spacing",
      o.relaxed, o.residualForce);
  if (o.atRest) return r.say(line);
  std::string why = ": it reached the limit of iterations before rest (below 1e-9, no births)";
  if (o.relaxStopped) why = ": it was stopped before rest";
  if (o.relaxStalled)
    why = fmt::format(
        ": it ended before rest (below 1e-9, no births), since for {} iterations neither the force (lowest "
        "{:.2e}) nor the number of particles ({}) made progress{}",
        o.relaxed - o.relaxProgress.gained, o.relaxProgress.least, o.relaxing,
        interpolates(r.world.scene) ? "; expected points on one smooth surface, with normals that agree, at "
                                      "most a few spacings apart"
                                    : "");
  r.warn(line + why);
}

/// Prints the number of particles of the first bodies, and of all others together.
void reportBodies(const Run& r, const SamplingReport& sampled) {
  constexpr std::size_t most = 100;
  const std::vector<Body>& bodies = r.world.scene.bodies;
  const std::size_t shown = std::min(most, bodies.size());
  for (std::size_t b = 0; b < shown; b++)
    r.say(fmt::format("body '{}': {}", bodies[b].name, counted(sampled.particles[b], "particle")));
  std::int64_t others = 0;
  for (std::size_t b = shown; b < bodies.size(); b++) others += sampled.particles[b];
  if (shown < bodies.size())
    r.say(fmt::format("{} more bodies: {} particles", bodies.size() - shown, others));
}

}  // namespace

RunStamp Run::stamp() const {
  return {name, world.scene.text, world.scene.output.piecesByRank,
          fmt::format("{}", fmt::join(summary.extensions, ", "))};
}

std::vector<std::string> Run::allWarnings() const {
  std::vector<std::string> list = summary.warnings;
  for (const std::string& line : countedWarnings)
    if (std::find(list.begin(), list.end(), line) == list.end()) list.push_back(line);
  return list;
}

void Run::publishWarnings() {
  if (!begun || !first() || !writes()) return;
  std::vector<std::string> list = allWarnings();
  if (list == publishedWarnings) return;
  try {
    writeWarnings(options.out, list);
    publishedWarnings = std::move(list);
  } catch (const IoError&) {  // the next frame or summary reports it on all ranks
  }
}

void onDisk(const Run& r, const std::function<void()>& work) {
  if (r.writes()) onFirstRank(r.comm.handle(), work);
}

StopMonitor stopMonitorOf(const Run& r) {
  StopMonitor monitor;
  if (r.first()) {
    if (r.writes()) monitor.stopFile = r.options.out + "/stop";
    monitor.timeLimit = r.options.timeLimit;
    monitor.start = r.startedAt;
  }
  return monitor;
}

void renewSurfaceHalos(Run& r) { r.surface = std::make_unique<SurfaceRanks>(r.comm, r.world.surface.grid); }

namespace {

void writeParticleFrame(Run& r) {
  World& w = r.world;
  findStoredEnergy(w, r.tools);
  if (w.modules.rigidify) deformPassive(r.tools.solid.elastic, w.solids, w.bonds);
  if (w.modules.solid && std::find(w.scene.output.fields.begin(), w.scene.output.fields.end(), "stress") !=
                             w.scene.output.fields.end())
    computeCauchyStress(r.tools.solid.elastic, w.solids);
  const Frame f = frameOf(w, r.comm.rank());
  const std::string file = frameName(r.name, w.clock.frame);
  writeFrame(frameFolder(r.options.out) + "/" + file, r.comm.handle(), f, r.stamp());
  onDisk(r, [&] {
    r.series.push_back({file, w.clock.time});
    writeSeries(seriesPath(r.options.out, r.name), r.series);
  });
}

/// Returns "  rigid 8000": particles in rigid parts of elastic solids. Collective.
std::string rigidText(Run& r) {
  const Continuum& p = r.world.particles;
  std::array<std::int64_t, 1> rigid{};
  for (std::size_t i = 0; i < p.owned; i++) rigid[0] += isRigid(p, i);
  r.all.sum(rigid);
  return fmt::format("  rigid {}", rigid[0]);
}

/// Returns "  sleeping 9 of 10 pieces". Collective.
std::string sleepingPiecesText(Run& r) {
  const Pieces& p = r.world.pieces;
  std::array<std::int64_t, 2> count{};
  for (std::size_t k = 0; k < p.owned; k++) {
    count[0] += p.recordsEnergy[k] && p.sleeping[k];
    count[1] += p.recordsEnergy[k];
  }
  r.all.sum(count);
  return fmt::format("  sleeping {} of {}", count[0], counted(count[1], "piece"));
}

/// Returns "  sleeping 8000 (awake: 12 move, 340 have awake neighbours)": particles whose sums were skipped
/// in the last step, and the reasons of the others. Returns "" if no particle may sleep. Collective.
std::string sleepText(Run& r) {
  if (r.world.modules.rigidify) return rigidText(r);
  if (r.world.modules.pieceSleep) return sleepingPiecesText(r);
  if (!r.world.modules.sleep) return "";
  std::array<std::int64_t, 2 + awakeReasons> counts{r.world.counters.sleeping,
                                                    static_cast<std::int64_t>(r.world.particles.owned)};
  std::ranges::copy(countAwake(r.world.particles, r.world.scene), counts.begin() + 2);
  r.all.sum(counts);
  constexpr const char* words[awakeReasons] = {"have awake neighbours", "are not solid", "move", "accelerate",
                                               "change temperature"};
  std::string why;
  std::int64_t unexplained = counts[1] - counts[0];
  for (const std::size_t k : {1u, 2u, 3u, 4u, 0u}) {
    unexplained -= counts[2 + k];
    if (counts[2 + k] > 0)
      why += fmt::format("{}{} {}", why.empty() ? " (awake: " : ", ", counts[2 + k], words[k]);
  }
  if (unexplained > 0)
    why += fmt::format("{}{} at rest, but not yet sleeping", why.empty() ? " (" : "; ", unexplained);
  return fmt::format("  sleeping {}{}", counts[0], why.empty() ? "" : why + ")");
}

}  // namespace

void writeFrameOf(Run& r) {
  World& w = r.world;
  r.tools.times.start();
  if (r.writes()) {
    if (hasContinuum(w.scene)) writeParticleFrame(r);
    if (w.modules.surface) writeSurfaceFrameOf(r);
    writeBodyTypeFrames(r);
  }
  w.clock.frame++;
  r.tools.times.lap(StepPhase::Frames);
  for (const auto& call : r.onFrame) call();
}

namespace {

/// Updates the warnings of counters, ledger and surface.
void countWarnings(Run& r, const Counters& counters) {
  r.countedWarnings = warningsOf(counters, r.summary.ledger);
  for (std::string& line : surfaceWarnings(r.summary.surface)) r.countedWarnings.push_back(std::move(line));
  r.publishWarnings();
}

}  // namespace

void report(Run& r) {
  r.tools.times.start();
  const LedgerReport l = reportLedger(r.world, r.tools, r.all);
  const bool first = r.world.clock.step == r.stepAtReport;
  const double rate = static_cast<double>(r.world.clock.step - r.stepAtReport) /
                      std::max(1e-9, since(r.lastReport));
  double left = (r.world.clock.end - r.world.clock.time) /
                std::max(1e-300, std::min(r.world.clock.dt, longestUnlimitedStep(r.world.clock)));
  if (r.options.steps >= 0) left = std::min(left, static_cast<double>(r.options.steps - r.world.clock.step));
  const Progress progress{r.world.clock, rate, first ? never : left / std::max(1e-9, rate)};
  gatherSurface(r);
  r.summary.ledger = l;
  r.summary.solvers = solversOf(r.world, r.tools);
  const std::string line = progressLine(progress, l) + sleepText(r) + progressOf(r.summary.solvers) +
                           progressOf(r.summary.surface);  // collective
  if (!r.options.status) r.say(line);
  else if (r.first()) r.options.status(statusLine(progress, l));
  onDisk(r, [&] { addToProgressLog(r.options.out, progress, r.summary); });
  countWarnings(r, sumOfCounters(r.world.counters, r.all));
  r.lastReport = WallClock::now();
  r.stepAtReport = r.world.clock.step;
  r.tools.times.lap(StepPhase::Other);
}

void warnOfUnused(Run& r) {
  for (const OrientedWork::Event& e : r.tools.oriented.idle) {
    const OrientedBody& body = r.world.scene.oriented[e.body];
    r.warn(unusedEventLine(body, body.events[e.event]));
  }
  for (const OrientedWork::Field& f : r.tools.oriented.unusedFields) {
    const OrientedBody& body = r.world.scene.oriented[f.body];
    r.warn(unusedFieldLine(body, body.fields[f.field]));
  }
  r.tools.oriented.idle.clear();
  r.tools.oriented.unusedFields.clear();
}

void warnOfInterpenetration(Run& r) {
  const World& w = r.world;
  if (w.modules.oriented &&
      r.obstacleInterpenetrationWarned.size() < w.scene.oriented.size() * w.walls.list.size())
    for (const Interpenetration& s : findObstacleInterpenetrations(w.oriented, w.walls, w.scene, r.all))
      if (r.obstacleInterpenetrationWarned.insert({s.oriented, s.body}).second)
        r.warn(interpenetrationLine(w.scene.oriented[s.oriented], w.walls.list[s.body].properties, s.count,
                                    w.clock.time));
  if (!w.modules.orientedContact || !w.modules.solid ||
      r.interpenetrationWarned.size() == w.scene.oriented.size() * w.scene.bodies.size())
    return;
  for (const Interpenetration& s : findInterpenetrations(r.world, r.halos()))
    if (r.interpenetrationWarned.insert({s.oriented, s.body}).second)
      r.warn(
          interpenetrationLine(w.scene.oriented[s.oriented], w.scene.bodies[s.body], s.count, w.clock.time));
}

void summarise(Run& r, const std::string& status, const std::string& message) {
  RunSummary& s = r.summary;
  s.status = status;
  s.message = message;
  s.ledger = reportLedger(r.world, r.tools, r.all);
  s.wall = since(r.startedAt);
  s.stepsHere = r.world.clock.step - r.firstStep;
  double moved = static_cast<double>(s.ledger.particles);
  for (const std::int64_t rows : s.ledger.rows) moved += static_cast<double>(rows);
  s.particleSteps = moved * static_cast<double>(s.stepsHere);
  s.solvers = solversOf(r.world, r.tools);
  gatherSummary(s, r.world, r.tools.times, r.comm.statistics(), r.all);
  gatherSurface(r);
  countWarnings(r, s.counters);
  onDisk(r, [&] {
    RunSummary all = s;
    all.warnings = r.allWarnings();
    writeSummary(r.options.out, all);
  });
}

void reportProfile(Run& r) {
  if (!r.profile) return;
  const std::unique_ptr<Profile> p = std::move(r.profile);
  endProfile(r.tools.times, r.comm);
  std::int64_t particles = static_cast<std::int64_t>(r.world.particles.owned);
  forEachBodyType(r.world, [&](std::size_t, const BodyTypeRows& rows, const CellTable&) {
    particles += static_cast<std::int64_t>(rows.owned);
  });
  r.all.sum({&particles, 1});
  for (const std::string& line :
       profileLines(*p, r.tools.times, r.world.clock.step - r.firstStep, particles, r.comm))
    r.say(line);
  if (!r.writes()) return;
  const std::string path = r.options.out + "/trace.json";
  writeTrace(path, r.comm, p->trace);
  r.say(fmt::format("  trace of the last steps: {} (ui.perfetto.dev opens it)", path));
}

void writeCheckpointOf(Run& r) {
  if (!r.writes()) return;
  r.tools.times.start();
  findStoredEnergy(r.world, r.tools);
  writeCheckpoint(r.options.out, r.comm.handle(), r.world, r.stamp(), restartRecordOf(r.world.scene));
  onDisk(r, [&] { dropUnusedSnapshots(r.options.out); });
  r.lastCheckpoint = WallClock::now();
  r.tools.times.lap(StepPhase::Checkpoint);
  summarise(r, "running", "");
}

void summariseFailure(Run& r, const std::string& message, bool together) {
  try {
    if (together && r.begun) return summarise(r, "failed", message);
  } catch (const std::exception&) { return; }
  summariseWithoutState(r, r.begun ? "failed" : "refused", message);
}

void summariseStoppedRelaxation(Run& r, const std::string& message) {
  summariseWithoutState(r, "stopped", message);
}

namespace {

/// Refuses to continue the run in the folder with this scene. why: the reason; about: a line for each entry,
/// which begins with its key.
[[noreturn]] void refuseScene(const Run& r, const std::string& why, const std::vector<std::string>& about) {
  std::vector<std::string> lines{fmt::format(
      "{}: error: the run in {} cannot continue with this scene. {}:", r.options.scene, r.options.out, why)};
  constexpr std::size_t most = 12;  // a different scene changes every entry
  for (const std::string& line : std::span(about).first(std::min(most, about.size())))
    lines.push_back("  " + line + placeOfRecordKey(r.world.scene, line));
  if (about.size() > most)
    lines.push_back(
        fmt::format("  and {} more; the checkpoint may be of another scene", about.size() - most));
  lines.push_back("  repeat the --set of the first run, or start again in another --out");
  throw SceneErrors(lines);
}

/// Returns the newest checkpoint if the run continues one, else null. Collective.
std::unique_ptr<CheckpointSlice> checkpointToContinue(Run& r) {
  if (!r.options.restart && !r.options.resume) return nullptr;
  auto slice = readNewestCheckpoint(r.options.out, r.comm.handle());
  if (r.options.restart && !slice)
    throw SceneErrors({r.options.out +
                       ": error: --restart needs a checkpoint in its folder checkpoint/, and there is none: "
                       "leave out --restart, or use --resume"});
  return slice;
}

/// Differences between a checkpoint's scene and this one, a line each.
struct SceneChanges {
  std::vector<std::string> coefficients, settings;
  bool any() const { return !coefficients.empty() || !settings.empty(); }
};

/// Restores the state of the world and its bonds. Throws SceneErrors where the scene does not fit the
/// checkpoint. Collective.
void restoreState(Run& r, const CheckpointSlice& slice, const SceneChanges& changes) {
  World& w = r.world;
  std::vector<std::byte> records;
  try {
    records = restoreWorld(w, slice, r.first());
  } catch (const IoError& e) {  // on all ranks alike; without a change the file is damaged
    if (!changes.any()) throw;
    std::vector<std::string> lines = changes.coefficients;
    lines.insert(lines.end(), changes.settings.begin(), changes.settings.end());
    refuseScene(r, std::string("A changed key needs data that the checkpoint lacks: ") + e.what(), lines);
  }
  if (const std::vector<std::string> strange = checkpointMismatches(w, r.all); !strange.empty())
    refuseScene(r, "The checkpoint does not match it", strange);
  if (w.modules.solid) r.tables.bonds->adopt(std::move(records));
}

void warnOfChanges(Run& r, const CheckpointHeader& then, const SceneChanges& changes) {
  const Scene& scene = r.world.scene;
  for (const auto& list : {changes.coefficients, changes.settings})
    for (const std::string& change : list) r.warn("changed at the restart: " + change);
  for (const std::string& change : pastEventChanges(then.values, scene, then.clock.time))
    r.warn("changed at the restart, without effect, since its time has passed: " + change);
  for (const std::string& change : initialStateChanges(then.values, scene))
    r.warn("changed at the restart, without effect, since it only sets the initial state: " + change);
}

/// Continues the run of a checkpoint. Collective.
void continueRun(Run& r, const CheckpointSlice& slice, const MeshLoader& load) {
  World& w = r.world;
  const CheckpointHeader& then = slice.header;
  for (const std::string& warning : slice.warnings) r.warn(warning);
  fingerprintMeshes(w.scene, load);
  if (const std::vector<std::string> differences = restartConflicts(then.values, w.scene);
      !differences.empty())
    refuseScene(r, "Values that must not change", differences);
  const SceneChanges changes{coefficientChanges(then.values, w.scene),
                             settingChanges(then.values, w.scene, then.clock.time)};
  restoreState(r, slice, changes);
  onDisk(r, [&] { makeOutputFolders(r.options.out); });
  warnOfChanges(r, then, changes);
  // Retries with other settings do not count.
  if (changes.any()) w.monitor.failures = 0;
  resumeWorld(w, r.halos(), r.tools);
  if (!changes.coefficients.empty()) {
    applyNewCoefficients(w, r.halos(), r.tools);
    w.monitor.snapshotStep = -1;  // earlier snapshots have the energies of the old coefficients
  }
  if (w.modules.surface) resumeSurface(w.surface, r.surface->halos(), r.surfaceTools);
  w.clock.limitedBy = "from the checkpoint";
  r.resumed = true;
  if (r.first()) r.series = framesPresent(r.options.out, r.name, w.clock.time);
  if (w.modules.surface) resumeSurfaceOutput(r);
  resumeBodyTypeFrames(r);
  r.say(fmt::format("continues at t {:.6g} s, step {}, from {}", w.clock.time, w.clock.step, then.path));
}

/// Prints the number of rows of each further body type. Collective.
void reportBodyTypes(Run& r) {
  forEachBodyType(r.world, [&](std::size_t kind, const BodyTypeRows& rows, const CellTable&) {
    std::int64_t n = static_cast<std::int64_t>(rows.owned);
    r.all.sum({&n, 1});
    r.say(fmt::format("{}: {} {}", bodyTypeNames[kind], n, kind == sheetType ? "vertices" : "particles"));
  });
}

void warnOfOverlaps(Run& r, const SamplingReport& sampled) {
  for (const BodyOverlap& pair : sampled.overlaps)
    r.warn(fmt::format("{}; {} particles left out in all", pair.text, sampled.removed));
}

/// Makes the output folders, and moves an earlier run in them aside.
void takeFolder(Run& r) {
  onDisk(r, [&] {
    if (moveEarlierRunAside(r.options.out))
      r.say(fmt::format("note: the earlier run in {0} is now in {0}/{1}", r.options.out, earlierRunFolder));
    makeOutputFolders(r.options.out);
  });
}

/// Begins a new run and writes its first frame. If a stop request ended relaxation, sets stoppedInRelaxation
/// and leaves the folder as it is. The run would differ from that of the scene. Collective.
void beginAnew(Run& r, const MeshLoader& load) {
  World& w = r.world;
  if (r.options.resume)
    r.say(fmt::format("{}: there is no checkpoint to resume from: the run starts from the beginning",
                      r.options.out));
  watchRelaxation(r);
  const SamplingReport sampled = r.start(load);
  fingerprintMeshes(w.scene, load);  // Unreadable files were reported before, with their body.
  reportBodies(r, sampled);
  reportBodyTypes(r);
  for (const SceneWarning& line : sampled.warnings) r.warn(warningLine(line.where, line.text));
  warnOfUnused(r);
  reportRelaxation(r);
  r.stoppedInRelaxation = r.tools.oriented.relaxStopped && r.options.relax == 0;
  if (r.stoppedInRelaxation) return;
  warnOfOverlaps(r, sampled);
  // Only now is the new run sure to start. An error in the scene leaves the earlier run as it is.
  takeFolder(r);
  r.begun = true;
  if (w.modules.surface) beginSurface(r, load);
  writeFrameOf(r);
}

void beginLogs(Run& r) {
  onDisk(r, [&] {
    const std::string& out = r.options.out;
    r.resumed ? truncateProgressLog(out, r.world.clock.step) : beginProgressLog(out);
    r.resumed ? truncateLedgerLog(out, r.world.modules, r.world.clock.step)
              : beginLedgerLog(out, r.world.modules);
    std::error_code code;
    std::filesystem::remove(out + "/" + refusedName, code);  // the refusal is obsolete
  });
  if (!r.resumed) writeLedgerRow(r);
}

}  // namespace

void begin(Run& r, const MeshLoader& load) {
  if (const auto slice = checkpointToContinue(r)) continueRun(r, *slice, load);
  else beginAnew(r, load);
  if (r.stoppedInRelaxation) return;
  r.begun = true;
  beginLogs(r);
  r.firstStep = r.stepAtReport = r.world.clock.step;
}

}  // namespace thaw
