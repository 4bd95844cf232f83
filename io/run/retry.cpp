// SPDX-License-Identifier: Apache-2.0
#include "io/run/retry.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "core/simulation/monitor/snapshot.hpp"
#include "core/simulation/sums/stored_energy.hpp"
#include "core/surface/resume_surface.hpp"
#include "io/hdf5/collective_error.hpp"
#include "io/run/body_type_failure.hpp"
#include "io/run/body_type_run.hpp"
#include "io/run/failure_text.hpp"
#include "io/run/ledger_log.hpp"
#include "io/run/reports/progress.hpp"
#include "io/run/restart/restart_record.hpp"
#include "io/run/surface_run.hpp"

namespace thaw {
namespace {

constexpr std::size_t mostLines = 20;  // retries among the warnings; all are counted

bool retries(const Run& r) { return r.world.scene.numerics.retryEvery > 0; }

/// Restores the world from the last snapshot.
void restoreLastSnapshot(Run& r) {
  World& w = r.world;
  const char* limitedBy = w.clock.limitedBy;
  std::unique_ptr<CheckpointSlice> slice;
  // If this throws, the world is unchanged.
  if (!r.snapshotInMemory)
    slice = readCheckpoint(snapshotFilePath(r.options.out, w.monitor.snapshotStep), r.comm.handle());
  emptyWorld(w, r.tools);
  r.makeHalos();
  if (w.modules.surface) renewSurfaceHalos(r);
  std::vector<std::byte> records = slice ? restoreWorld(w, *slice, r.first()) : restoreSnapshot(r.good, w);
  if (w.modules.solid) r.tables.bonds->adopt(std::move(records));
  resumeWorld(w, r.halos(), r.tools);
  if (w.modules.surface) resumeSurface(w.surface, r.surface->halos(), r.surfaceTools);
  if (slice) w.clock.limitedBy = limitedBy;
  if (!r.snapshotInMemory) takeSnapshot(w, r.good);
  r.snapshotInMemory = true;
}

/// Removes the frames and rows after the snapshot, which are written again.
void removeFramesAfterSnapshot(Run& r) {
  onDisk(r, [&] {
    removeFramesAfter(r.options.out, r.name, r.series, r.world.clock.time);
    truncateProgressLog(r.options.out, r.world.clock.step);
    truncateLedgerLog(r.options.out, r.world.modules, r.world.clock.step);
    if (r.world.modules.surface) removeSurfaceFrames(r);
    removeBodyTypeFrames(r);
  });
  if (r.history) r.history->removeAfter(r.world.clock.step);
}

/// Returns the attempted retries and the reason for no further one; "" without retries.
std::string triedText(const Run& r, const MonitorState& monitor) {
  const Numerics& n = r.world.scene.numerics;
  if (!retries(r) || n.retries == 0) return "";
  std::string text;
  if (monitor.failures > 0)
    text = fmt::format("; {} retries from step {} with steps down to 1/{} did not help", monitor.failures,
                       monitor.snapshotStep, std::int64_t(1) << monitor.backoff);
  if (monitor.failures < n.retries && retryTooShort(r.world.monitor, r.world.clock, r.tools.limits.monitor))
    text += fmt::format("; half the step would be below {:.3g} s (`numerics.watch_step`)",
                        r.tools.limits.monitor.step);
  return text;
}

/// Makes the last snapshot the checkpoint of a run that gives up. Returns the end of its message.
std::string keepSnapshot(Run& r) {
  if (!r.snapshotInMemory || r.snapshotOnDisk) return "; the last checkpoint is older";
  writeCheckpoint(r.options.out, r.comm.handle(), r.good, r.stamp(), restartRecordOf(r.world.scene));
  return fmt::format("; the checkpoint holds step {}, before the failure", r.good.world.clock.step);
}

}  // namespace

void beginRetries(Run& r) {
  World& w = r.world;
  if (!retries(r)) {
    w.monitor.snapshotStep = -1;
    return;
  }
  const std::int64_t step = w.clock.step, good = w.monitor.snapshotStep;
  if (good >= 0 && good < step && step % w.scene.numerics.retryEvery != 0) {
    int there = 0;
    onDisk(r, [&] {
      std::error_code error;
      there = std::filesystem::exists(snapshotFilePath(r.options.out, good), error);
    });
    MPI_Bcast(&there, 1, MPI_INT, 0, r.comm.handle());
    r.snapshotOnDisk = there != 0;
    if (there) return;  // it is read when it is needed
    r.warn(fmt::format("{} is missing: a retry can only go back to step {}",
                       snapshotFilePath(r.options.out, good), step));
  }
  if (good != step) acceptState(w.monitor, w.clock, reportLedger(w, r.tools, r.all));
  findStoredEnergy(w, r.tools);
  takeSnapshot(w, r.good);
  r.snapshotInMemory = true;
}

bool snapshotDue(const Run& r) {
  return retries(r) && r.world.clock.step % r.world.scene.numerics.retryEvery == 0;
}

bool atSnapshot(const Run& r) { return !retries(r) || r.world.monitor.snapshotStep == r.world.clock.step; }

Failure checkLedgerOf(Run& r) {
  r.tools.times.start();
  r.snapshotLedger = reportLedger(r.world, r.tools, r.all);
  const Failure failure = checkEnergyBudget(r.world, r.tools.limits.monitor, r.snapshotLedger, r.all);
  r.tools.times.lap(StepPhase::Other);
  return failure;
}

void acceptSnapshot(Run& r) {
  r.tools.times.start();
  acceptState(r.world.monitor, r.world.clock, r.snapshotLedger);
  findStoredEnergy(r.world, r.tools);
  takeSnapshot(r.world, r.good);
  r.snapshotInMemory = true;
  r.snapshotOnDisk = false;
  r.tools.times.lap(StepPhase::Checkpoint);
}

void acceptEdit(Run& r) {
  r.edited = false;
  if (!retries(r)) return;
  r.snapshotLedger = reportLedger(r.world, r.tools, r.all);
  acceptSnapshot(r);
}

void writeLastSnapshot(Run& r) {
  World& w = r.world;
  if (atSnapshot(r)) return;
  if (w.clock.time >= w.clock.end) {  // The run has ended. A later end starts a new period of the check.
    acceptState(w.monitor, w.clock, reportLedger(w, r.tools, r.all));
    return;
  }
  if (r.snapshotOnDisk || !r.writes()) return;
  writeSnapshot(r.options.out, r.comm.handle(), r.good, r.stamp(), restartRecordOf(w.scene));
  r.snapshotOnDisk = true;
}

bool rollBack(Run& r, const StepOutcome& failed, std::string& why) {
  World& w = r.world;
  const Clock clock = w.clock;
  const MonitorState monitor = w.monitor;
  findStoredEnergy(w, r.tools);
  const FailingParticle s = findFailingParticle(w, failed.failure, failed.limitedBy, r.all);
  const std::string ofBodyTypes = bodyTypeFailure(w, r.tools, failed, r.all);  // on at most one rank
  double found = ofBodyTypes.empty() ? 0 : 1;
  r.all.maximum({&found, 1});
  std::string what = broadcastFromOwner(r.comm, found > 0 ? ofBodyTypes
                                                : s.here  ? failureText(w, r.tools, failed, s)
                                                          : std::string());
  if (what.empty()) what = failedCheck(w, r.tools, failed) + "; no single particle is responsible";
  const std::string when = fmt::format("step {}, t {:.9g} s, dt {:.3g} s", clock.step, clock.time,
                                       clock.stepDt);
  std::string problem;
  if (mayRetry(w.scene.numerics, w.monitor, w.clock, r.tools.limits.monitor)) {
    try {
      const std::int64_t mine = w.counters.retries + (r.first() ? 1 : 0);
      restoreLastSnapshot(r);
      w.counters.retries = mine;
      halveStep(w.monitor, w.clock, w.scene, monitor, clock.time);
      removeFramesAfterSnapshot(r);
      const std::string line = fmt::format(
          "failed at {}: {}; back to step {}, t {:.6g} s, with 1/{} of the step", when, what, w.clock.step,
          w.clock.time, std::int64_t(1) << w.monitor.backoff);
      if (r.summary.warnings.size() < mostLines) r.warn(line);
      else r.say("warning: " + line);
      r.firstStep -= clock.step - w.clock.step;  // counts the steps that were done
      r.stepAtReport = w.clock.step;
      r.lastReport = WallClock::now();
      return true;
    } catch (const IoError& e) {  // on all ranks, before any change
      problem = fmt::format("; the snapshot cannot be read: {}", e.what());
    }
  }
  if (r.writes()) problem += keepSnapshot(r);
  why = fmt::format("blew up at {}: {}{}{}", when, what, triedText(r, monitor), problem);
  return false;
}

}  // namespace thaw
