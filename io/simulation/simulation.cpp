// SPDX-License-Identifier: Apache-2.0
#include "io/simulation/simulation.hpp"

#include <fmt/format.h>

#include <utility>

#include "io/hdf5/collective_error.hpp"
#include "io/hdf5/io_error.hpp"
#include "io/run/advance.hpp"
#include "io/run/failure_text.hpp"
#include "io/run/open_run.hpp"
#include "io/run/retry.hpp"
#include "io/run/run_lock.hpp"
#include "io/run/surface_run.hpp"
#include "io/scene/check_built_scene.hpp"
#include "io/scene/read_scene.hpp"
#include "io/scene/scene_for_all.hpp"
#include "io/simulation/edit.hpp"

namespace thaw {
namespace {

std::string failureMessage(const std::string& scene, const std::exception& e) {
  if (const auto refusal = refusalOf(e)) return refusal->message;
  return scene + ": error: " + e.what();
}

/// Gives a scene without a file a name for messages and frames.
RunOptions withName(RunOptions options) {
  if (options.scene.empty()) options.scene = "scene";
  return options;
}

}  // namespace

namespace {

/// Functions of the program, which a restored simulation keeps.
struct Functions {
  std::vector<std::function<void()>> onStep, onFrame, onEnd;
  std::vector<std::pair<HookPhase, std::function<void()>>> onPhase;
  std::vector<OutsideSource> loads;
};

}  // namespace

struct Simulation::Parts {
  RunOptions options;
  Communicator comm;
  std::unique_ptr<RunLock> lock = std::make_unique<RunLock>();
  Run run;
  StepLoop loop;
  Functions functions;
  Scene given;           // with a folder, for restore()
  bool inPhase = false;  // a function of onPhase runs
  Opened opened = Opened::Ready;
  bool stopped = false, blewUp = false, finished = false;
  bool restoredLoads = false;  // the checkpoint's accelerations contain the loads that are added next
  Edit edit;

  Parts(RunOptions o, MPI_Comm c) : options(std::move(o)), comm(c), run(options, comm) {
    if (options.history) run.history = std::make_unique<LedgerHistory>();
  }

  /// Locks the folder and prepares the run. A failure leaves its summary.
  void open(Scene scene) {
    if (run.writes()) given = scene;
    try {
      opened = openRun(run, std::move(scene));
      stopped = opened == Opened::StoppedInRelaxation;
      restoredLoads = run.resumed && run.world.particles.outsideForce.active;
      loop.stop = stopMonitorOf(run);
    } catch (const std::exception& e) {
      summariseFailure(run, failureMessage(options.scene, e), true);
      throw;
    }
  }
  /// Calls `work`. After an error on all ranks, writes a summary of their state.
  template<class Work> auto guarded(Work work) {
    try {
      return work();
    } catch (const IoError& e) {
      summariseFailure(run, failureMessage(options.scene, e), true);
      throw;
    } catch (const std::exception& e) {  // out of memory, a broken invariant: other ranks may go on
      summariseFailure(run, e.what(), false);
      lock->release();
      throw;
    }
  }
  void takeLock() {
    if (options.restart && options.out.empty())
      throw SceneErrors({options.scene + ": error: a restart needs the folder of a run"});
    std::string note;
    onDisk(run,
           [&] { note = lock->take({.out = options.out, .ranks = comm.size(), .force = options.force}); });
    if (!note.empty()) run.say(note);
  }
  /// Throws std::logic_error within a function of the program, or while an edit is open.
  void refuseBusy(const char* what) const {
    if (run.advancing || inPhase)
      throw std::logic_error(fmt::format("{}: not possible within a step; do it after the step", what));
    refuseEdit(what);
  }
  void refuseEdit(const char* what) const {
    if (edit.open)
      throw std::logic_error(fmt::format("{}: not possible while an edit is open; end it first", what));
  }
  void addToPhase(HookPhase phase, const std::function<void()>& call) {
    run.tools.hooks.calls.at(static_cast<std::size_t>(phase)).push_back([this, call] {
      inPhase = true;
      try {
        call();
      } catch (...) {
        inPhase = false;
        throw;
      }
      inPhase = false;
    });
  }
};

Simulation::Simulation(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}

Simulation::Simulation(RunOptions options, MPI_Comm comm)
    : parts_(std::make_unique<Parts>(std::move(options), comm)) {
  parts_->takeLock();
  parts_->open(sceneForAll(parts_->comm, parts_->options.scene, parts_->options.overrides));
}

Simulation::Simulation(Scene scene, RunOptions options, MPI_Comm comm)
    : parts_(std::make_unique<Parts>(withName(std::move(options)), comm)) {
  checkBuiltScene(scene, parts_->options.scene);
  parts_->takeLock();
  parts_->open(std::move(scene));
}

Simulation Simulation::fromText(const std::string& text, RunOptions options, MPI_Comm comm) {
  options = withName(std::move(options));
  Scene scene = readScene(sceneFilesOf(options.scene, text), options.overrides);
  auto parts = std::make_unique<Parts>(std::move(options), comm);
  parts->takeLock();
  parts->open(std::move(scene));
  return Simulation(std::move(parts));
}

Simulation::~Simulation() = default;
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;

bool Simulation::atEnd() const {
  const Clock& c = parts_->run.world.clock;
  const long long most = parts_->options.steps;
  return parts_->opened != Opened::Ready || parts_->stopped || parts_->blewUp || parts_->finished ||
         c.time >= c.end || (most >= 0 && c.step >= most);
}

bool Simulation::step() {
  parts_->refuseBusy("step");
  if (atEnd()) return false;
  parts_->restoredLoads = false;
  switch (parts_->guarded([&] { return advance(parts_->run, parts_->loop); })) {
    case Advance::Stopped: parts_->stopped = true; break;
    case Advance::BlewUp: parts_->blewUp = true; throw BlewUp("the simulation " + parts_->loop.why);
    case Advance::Stepped:
    case Advance::RolledBack: break;
  }
  return true;
}

void Simulation::run() {
  while (step()) {}
}

void Simulation::runUntil(double time) {
  setEnd(time);
  run();
  setEnd(scene().end);
}

void Simulation::setEnd(double time) { parts_->run.world.clock.end = time; }

void Simulation::runSteps(std::int64_t count) {
  for (std::int64_t n = 0; n < count && step(); n++) {}
}

int Simulation::finish() {
  Parts& p = *parts_;
  p.refuseBusy("finish");
  int code = p.blewUp ? exitBlewUp : p.stopped ? exitStopped : exitDone;
  if (!p.finished)
    for (const auto& call : p.functions.onEnd) call();
  if (p.opened == Opened::Ready && !p.finished)
    code = p.guarded([&] { return finishRun(p.run, code, p.loop.why); });
  p.finished = true;
  p.lock->release();
  return code;
}

bool Simulation::stopped() const { return parts_->stopped; }
const std::string& Simulation::stopReason() const { return parts_->loop.why; }
double Simulation::time() const { return parts_->run.world.clock.time; }
double Simulation::lastStep() const { return parts_->run.world.clock.stepDt; }
std::int64_t Simulation::steps() const { return parts_->run.world.clock.step; }
const Scene& Simulation::scene() const { return parts_->run.world.scene; }
const World& Simulation::world() const { return parts_->run.world; }
const Continuum& Simulation::particles() const { return parts_->run.world.particles; }
const Surfels& Simulation::surfels() const { return parts_->run.world.surface.surfels; }
const Sheets& Simulation::sheets() const { return parts_->run.world.sheets.rows; }
const Oriented& Simulation::oriented() const { return parts_->run.world.oriented.rows; }
bool Simulation::writes() const { return parts_->run.writes(); }
bool Simulation::busy() const { return parts_->run.advancing || parts_->inPhase; }
World& Simulation::world() { return parts_->run.world; }
MPI_Comm Simulation::communicator() const { return parts_->comm.handle(); }
const std::vector<std::string>& Simulation::warnings() const { return parts_->run.summary.warnings; }
int Simulation::rank() const { return parts_->comm.rank(); }
int Simulation::ranks() const { return parts_->comm.size(); }

LedgerReport Simulation::ledger() {
  return reportLedger(parts_->run.world, parts_->run.tools, parts_->run.all);
}

void Simulation::updateSurface() { updateSurfaceOf(parts_->run); }

const LedgerHistory& Simulation::history() const {
  if (!parts_->run.history) throw std::logic_error("history needs RunOptions::history");
  return *parts_->run.history;
}

void Simulation::writeFrame() {
  if (!parts_->run.writes()) throw std::logic_error("a frame needs the folder of a run (RunOptions::out)");
  parts_->refuseEdit("writeFrame");
  writeFrameOf(parts_->run);
}

void Simulation::writeCheckpoint() {
  if (!parts_->run.writes())
    throw std::logic_error("a checkpoint needs the folder of a run (RunOptions::out)");
  parts_->refuseEdit("writeCheckpoint");
  if (parts_->inPhase) throw std::logic_error("writeCheckpoint: not possible within a step");
  writeCheckpointOf(parts_->run);
}

void Simulation::restore() {
  Parts& old = *parts_;
  old.refuseBusy("restore");
  if (!old.run.writes()) throw std::logic_error("restore needs the folder of a run (RunOptions::out)");
  RunOptions options = old.options;
  options.restart = true;
  auto fresh = std::make_unique<Parts>(std::move(options), old.comm.handle());
  fresh->open(old.given);
  fresh->lock = std::move(old.lock);
  fresh->functions = std::move(old.functions);
  const Functions& f = fresh->functions;
  Run& r = fresh->run;
  r.onStep = f.onStep;
  r.onFrame = f.onFrame;
  for (const auto& [phase, call] : f.onPhase) fresh->addToPhase(phase, call);
  Continuum& p = r.world.particles;
  if (!f.loads.empty() && !p.outsideForce.active) p.activate(p.outsideForce);
  r.tools.terms.outside.insert(r.tools.terms.outside.end(), f.loads.begin(), f.loads.end());
  parts_ = std::move(fresh);
}

void Simulation::onStep(std::function<void()> call) {
  parts_->functions.onStep.push_back(call);
  parts_->run.onStep.push_back(std::move(call));
}
void Simulation::onFrame(std::function<void()> call) {
  parts_->functions.onFrame.push_back(call);
  parts_->run.onFrame.push_back(std::move(call));
}
void Simulation::onPhase(HookPhase phase, std::function<void()> call) {
  parts_->addToPhase(phase, call);
  parts_->functions.onPhase.emplace_back(phase, std::move(call));
}
void Simulation::onEnd(std::function<void()> call) { parts_->functions.onEnd.push_back(std::move(call)); }

void Simulation::addForce(OutsideSource source) {
  parts_->refuseBusy("addForce");
  Run& r = parts_->run;
  Continuum& p = r.world.particles;
  if (!p.outsideForce.active) p.activate(p.outsideForce);
  parts_->functions.loads.push_back(source);
  r.tools.terms.outside.push_back(std::move(source));
  if (!parts_->restoredLoads) applyNewCoefficients(r.world, r.halos(), r.tools);
}

Continuum& Simulation::beginEdit() {
  if (parts_->inPhase)
    throw std::logic_error("velocities and temperatures cannot be changed within a step: do it after a step");
  parts_->refuseEdit("beginEdit");
  parts_->edit = startEdit(parts_->run.world.particles);
  return parts_->run.world.particles;
}

bool Simulation::endEdit() {
  if (!parts_->edit.open) throw std::logic_error("endEdit: no edit is open; call beginEdit first");
  Run& r = parts_->run;
  Continuum& p = r.world.particles;
  const Edit edit = std::exchange(parts_->edit, {});
  std::string problem = editProblem(p, edit);
  if (!problem.empty() && ranks() > 1) problem = fmt::format("rank {}: {}", rank(), problem);
  double flags[] = {isEdited(p, edit) ? 1.0 : 0.0, problem.empty() ? 0.0 : 1.0};
  r.all.maximum(flags);
  if (flags[1] > 0) {
    undoEdit(p, edit);
    throw std::invalid_argument(broadcastFromOwner(r.comm, problem) + "; the changes are taken back");
  }
  if (flags[0] == 0) return false;
  recordEdit(r.world.particles, r.world.ledger, r.world.scene, edit);
  applyNewCoefficients(r.world, r.halos(), r.tools);
  r.edited = true;
  if (!r.advancing) acceptEdit(r);
  return true;
}

Run& Simulation::runState() { return parts_->run; }

void Simulation::requestStop() { parts_->loop.stop.requested = true; }

void Simulation::resume() {
  parts_->stopped = false;
  parts_->loop.stop.requested = false;
  parts_->loop.why.clear();
}

}  // namespace thaw
