// SPDX-License-Identifier: Apache-2.0
#include "io/run/advance.hpp"

#include "core/surface/surface_due.hpp"
#include "core/time/frame_times.hpp"
#include "io/run/ledger_log.hpp"
#include "io/run/retry.hpp"
#include "io/run/surface_run.hpp"

namespace thaw {
namespace {

/// Marks a run as within a step, for the lifetime of this object.
class Advancing {
 public:
  explicit Advancing(Run& r) : run_(r) { run_.advancing = true; }
  ~Advancing() { run_.advancing = false; }
  Advancing(const Advancing&) = delete;
  Advancing& operator=(const Advancing&) = delete;

 private:
  Run& run_;
};

/// Takes a step, and records it in the trace.
StepOutcome tracedStep(Run& r, Requests wanted) {
  const auto begin = StepTrace::Clock::now();
  if (r.profile) r.profile->trace.beginStep(r.world.clock.step);
  StepOutcome o = r.step(wanted);
  if (r.profile) r.profile->trace.add(TraceKind::Step, 0, begin, StepTrace::Clock::now());
  return o;
}

/// Updates the surface and writes what is due. before: time (s) before the step.
void writeWhatIsDue(Run& r, const StepOutcome& o, double before) {
  World& w = r.world;
  if (w.modules.surface &&
      (frameDue(w.clock) || surfaceDue(w.scene, w.clock, w.grid, w.surface, o.surfaceMove2)))
    updateSurfaceOf(r);
  const bool row = ledgerRowDue(w.scene, w.clock, before);
  for (const auto& call : r.onStep) call();
  while (frameDue(w.clock)) writeFrameOf(r);
  if (row) writeLedgerRow(r);
}

}  // namespace

Advance advance(Run& r, StepLoop& loop) {
  World& w = r.world;
  const Advancing mark(r);
  Requests wanted;
  const std::string reason = loop.stop.reason();
  const double before = w.clock.time;
  wanted.stop = !reason.empty();
  wanted.report = r.first() && since(r.lastReport) >= r.options.reportEvery;
  wanted.checkpoint = r.first() && since(r.lastCheckpoint) >= w.scene.output.checkpoint;
  StepOutcome o = tracedStep(r, wanted);
  // The last step is checked as well, for runs shorter than retry_every.
  const bool good = snapshotDue(r), last = w.clock.time >= w.clock.end && w.scene.numerics.retryEvery > 0;
  if ((good || last) && o.failure == Failure::None) o.failure = checkLedgerOf(r);
  warnOfUnused(r);
  if (o.failure != Failure::None) return rollBack(r, o, loop.why) ? Advance::RolledBack : Advance::BlewUp;
  writeWhatIsDue(r, o, before);
  if (good || w.clock.time >= w.clock.end) warnOfInterpenetration(r);
  if (r.edited) acceptEdit(r);
  else if (good) acceptSnapshot(r);
  if (o.requests.report) report(r);
  if (o.requests.stop) {
    loop.why = reason.empty() ? "a signal to another rank" : reason;
    return Advance::Stopped;
  }
  if (o.requests.checkpoint && atSnapshot(r)) writeCheckpointOf(r);
  if (w.clock.step % 25 == 0) {
    r.tools.times.start();
    balance(w, *r.tables.cells, r.tools, loop.meter);
    r.tools.times.lap(StepPhase::Balance);
  }
  return Advance::Stepped;
}

}  // namespace thaw
