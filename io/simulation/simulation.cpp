// SPDX-License-Identifier: Apache-2.0
#include "io/simulation/simulation.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/materials/enthalpy.hpp"
#include "io/hdf5/collective_error.hpp"
#include "io/hdf5/io_error.hpp"
#include "io/run/advance.hpp"
#include "io/run/open_run.hpp"
#include "io/run/run_lock.hpp"
#include "io/run/surface_run.hpp"
#include "io/scene/read_scene.hpp"
#include "io/scene/scene_for_all.hpp"

namespace thaw {
namespace {

/// Records the change of velocities and temperatures of the owned rows since the given ones in the ledger.
/// Returns whether there is one. Enthalpies follow the temperatures.
bool recordEdit(World& w, const std::vector<Vec3d>& velocity, const std::vector<double>& temperature) {
  Continuum& p = w.particles;
  Ledger& ledger = w.ledger;
  bool changed = false;
  for (std::size_t i = 0; i < p.owned; i++) {
    const Vec3d dv = p.velocity[i] - velocity[i];
    if (dv.x != 0 || dv.y != 0 || dv.z != 0) {
      changed = true;
      ledger.wallWork.add(0.5 * p.mass[i] * dot(dv, p.velocity[i] + velocity[i]));
      for (int a = 0; a < 3; a++) ledger.wallImpulse[a].add(p.mass[i] * dv[a]);
    }
    if (temperature.empty() || p.temperature[i] == temperature[i]) continue;
    changed = true;
    const double f = p.liquid.active ? static_cast<double>(p.liquid[i]) : 0;
    const double enthalpy = ledgerEnthalpy(w.scene.numerics.heat, w.scene.materials[p.material[i]],
                                           p.temperature[i], f);
    ledger.heatIn.add(p.mass[i] * (enthalpy - p.enthalpy[i]));
    p.enthalpy[i] = enthalpy;
  }
  return changed;
}

std::string failureMessage(const std::string& scene, const std::exception& e) {
  if (const auto refusal = refusalOf(e)) return refusal->message;
  return scene + ": error: " + e.what();
}

}  // namespace

struct Simulation::Parts {
  RunOptions options;
  Communicator comm;
  RunLock lock;
  Run run;
  StepLoop loop;
  std::vector<std::function<void()>> onEnd;
  bool inPhase = false;  // a function of onPhase runs
  Opened opened = Opened::Ready;
  bool stopped = false, blewUp = false, finished = false;
  bool restoredLoads = false;       // the checkpoint's accelerations contain the loads that are added next
  std::vector<Vec3d> velocity;      // at the start of an edit, by owned row
  std::vector<double> temperature;  // the same

  Parts(RunOptions o, MPI_Comm c) : options(std::move(o)), comm(c), run(options, comm) {}

  /// Locks the folder and prepares the run. A failure leaves its summary.
  void open(Scene scene) {
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
  /// Calls `work`. An error that all ranks have leaves a summary of their state.
  template<class Work> auto guarded(Work work) {
    try {
      return work();
    } catch (const IoError& e) {
      summariseFailure(run, failureMessage(options.scene, e), true);
      throw;
    } catch (const std::exception& e) {  // out of memory, a broken invariant: other ranks may go on
      summariseFailure(run, e.what(), false);
      lock.release();
      throw;
    }
  }
  void takeLock() {
    if (options.restart && options.out.empty())
      throw SceneErrors({options.scene + ": error: a restart needs the folder of a run"});
    std::string note;
    onDisk(run,
           [&] { note = lock.take({.out = options.out, .ranks = comm.size(), .force = options.force}); });
    if (!note.empty()) run.say(note);
  }
};

Simulation::Simulation(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}

Simulation::Simulation(RunOptions options, MPI_Comm comm)
    : parts_(std::make_unique<Parts>(std::move(options), comm)) {
  parts_->takeLock();
  parts_->open(sceneForAll(parts_->comm, parts_->options.scene, parts_->options.overrides));
}

Simulation::Simulation(Scene scene, RunOptions options, MPI_Comm comm)
    : parts_(std::make_unique<Parts>(std::move(options), comm)) {
  parts_->takeLock();
  parts_->open(std::move(scene));
}

Simulation Simulation::fromText(const std::string& text, RunOptions options, MPI_Comm comm) {
  Scene scene = readScene(sceneFilesOf(options.scene, text), options.overrides);
  return Simulation(std::move(scene), std::move(options), comm);
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
  int code = p.blewUp ? exitBlewUp : p.stopped ? exitStopped : exitDone;
  if (!p.finished)
    for (const auto& call : p.onEnd) call();
  if (p.opened == Opened::Ready && !p.finished)
    code = p.guarded([&] { return finishRun(p.run, code, p.loop.why); });
  p.finished = true;
  p.lock.release();
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
World& Simulation::world() { return parts_->run.world; }
MPI_Comm Simulation::communicator() const { return parts_->comm.handle(); }
const std::vector<std::string>& Simulation::warnings() const { return parts_->run.summary.warnings; }
int Simulation::rank() const { return parts_->comm.rank(); }
int Simulation::ranks() const { return parts_->comm.size(); }

LedgerReport Simulation::ledger() {
  return reportLedger(parts_->run.world, parts_->run.tools, parts_->run.all);
}

void Simulation::updateSurface() { updateSurfaceOf(parts_->run); }

void Simulation::writeFrame() {
  if (!parts_->run.writes()) throw std::logic_error("a frame needs the folder of a run (RunOptions::out)");
  writeFrameOf(parts_->run);
}

void Simulation::writeCheckpoint() {
  if (!parts_->run.writes())
    throw std::logic_error("a checkpoint needs the folder of a run (RunOptions::out)");
  writeCheckpointOf(parts_->run);
}

void Simulation::onStep(std::function<void()> call) { parts_->run.onStep.push_back(std::move(call)); }
void Simulation::onFrame(std::function<void()> call) { parts_->run.onFrame.push_back(std::move(call)); }
void Simulation::onPhase(HookPhase phase, std::function<void()> call) {
  const auto during = [parts = parts_.get(), call = std::move(call)] {
    parts->inPhase = true;
    try {
      call();
    } catch (...) {
      parts->inPhase = false;
      throw;
    }
    parts->inPhase = false;
  };
  parts_->run.tools.hooks.calls.at(static_cast<std::size_t>(phase)).push_back(during);
}
void Simulation::onEnd(std::function<void()> call) { parts_->onEnd.push_back(std::move(call)); }

void Simulation::addForce(OutsideSource source) {
  Run& r = parts_->run;
  Continuum& p = r.world.particles;
  if (!p.outsideForce.active) p.activate(p.outsideForce);
  r.tools.outside.push_back(std::move(source));
  if (!parts_->restoredLoads) applyNewCoefficients(r.world, r.halos(), r.tools);
}

Continuum& Simulation::beginEdit() {
  if (parts_->inPhase)
    throw std::logic_error("velocities and temperatures cannot be changed within a step: do it after a step");
  const World& w = parts_->run.world;
  const Continuum& p = w.particles;
  parts_->velocity.assign(p.velocity.data(), p.velocity.data() + p.owned);
  if (p.temperature.active) parts_->temperature.assign(p.temperature.data(), p.temperature.data() + p.owned);
  return parts_->run.world.particles;
}

bool Simulation::endEdit() {
  Run& r = parts_->run;
  const std::vector<Vec3d> velocity = std::exchange(parts_->velocity, {});
  const std::vector<double> temperature = std::exchange(parts_->temperature, {});
  double changed = recordEdit(r.world, velocity, temperature) ? 1 : 0;
  r.all.maximum({&changed, 1});
  if (changed == 0) return false;
  applyNewCoefficients(r.world, r.halos(), r.tools);
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
