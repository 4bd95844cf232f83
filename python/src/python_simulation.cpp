// SPDX-License-Identifier: Apache-2.0
#include "python/src/python_simulation.hpp"

#include <pybind11/stl.h>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <numeric>
#include <stdexcept>

#include "io/run/ledger_history.hpp"
#include "io/scene/read_scene.hpp"

namespace py = pybind11;

namespace thaw::python {
namespace {

RunOptions runOptions(const Options& given, const py::object& log) {
  RunOptions o;
  const auto text = [&](const char* key) {
    const auto at = given.find(key);
    return at == given.end() ? std::string() : at->second;
  };
  o.scene = text("scene");
  o.history = true;
  o.out = text("out");
  o.restart = !text("restart").empty();
  o.resume = !text("resume").empty();
  o.force = !text("force").empty();
  if (const std::string limit = text("time_limit"); !limit.empty()) o.timeLimit = std::stod(limit);
  if (const std::string every = text("report_every"); !every.empty()) o.reportEvery = std::stod(every);
  for (const auto& [key, value] : given)
    if (key.rfind("set ", 0) == 0) o.overrides.push_back(key.substr(4) + "=" + value);
  if (!log.is_none())
    o.log = [call = keepFunction(log)](const std::string& line) { guarded([&] { (*call)(line); }); };
  return o;
}

Simulation make(const std::string& text, RunOptions options, std::optional<int> comm, ProgramCalls& calls) {
  const CallScope scope(calls);
  const MPI_Comm handle = comm ? MPI_Comm_f2c(*comm) : MPI_COMM_WORLD;
  const py::gil_scoped_release others;
  return text.empty() ? Simulation(std::move(options), handle)
                      : Simulation::fromText(text, std::move(options), handle);
}

/// All ranks' bytes one after another, on every rank.
std::vector<std::byte> allRows(MPI_Comm comm, const std::byte* mine, std::size_t bytes) {
  int ranks = 0;
  MPI_Comm_size(comm, &ranks);
  std::vector<int> counts(static_cast<std::size_t>(ranks)), starts(counts.size() + 1, 0);
  const int here = static_cast<int>(bytes);
  MPI_Allgather(&here, 1, MPI_INT, counts.data(), 1, MPI_INT, comm);
  std::partial_sum(counts.begin(), counts.end(), starts.begin() + 1);
  std::vector<std::byte> all(static_cast<std::size_t>(starts.back()));
  MPI_Allgatherv(mine, here, MPI_BYTE, all.data(), counts.data(), starts.data(), MPI_BYTE, comm);
  return all;
}

/// Kinds of functions of the program; those of extensions and loads have no list.
enum FunctionKind : std::size_t { afterStep, afterFrame, atEnd, duringStep, afterPhase };
constexpr std::size_t kinds = afterPhase + hookPhaseNames.size();

}  // namespace

/// Marks the simulation as in use by this thread, and makes its calls the current ones.
class PythonSimulation::Busy {
 public:
  explicit Busy(PythonSimulation& s) : sim_(s), before_(s.busy_), scope_(*s.calls_) {
    s.busy_ = std::this_thread::get_id();
  }
  ~Busy() { sim_.busy_ = before_; }
  Busy(const Busy&) = delete;
  Busy& operator=(const Busy&) = delete;

 private:
  PythonSimulation& sim_;
  std::thread::id before_;
  CallScope scope_;
};

template<class Work> auto PythonSimulation::together(const std::string& what, const Work& work) {
  refuseOtherThread();
  const Busy busy(*this);
  SharedFailure failure;
  std::optional<decltype(work(failure))> result;
  {
    const py::gil_scoped_release others;
    meet(calls_->meeting, what);
    result = work(failure);
  }
  if (failure) endRun(failure);
  return *result;
}

PythonSimulation::PythonSimulation(const std::string& text, const Options& options, const py::object& log,
                                   std::optional<int> comm)
    : sim_(make(text, runOptions(options, log), comm, *calls_)) {
  calls_->meeting.comm = sim_.communicator();
  if (!sim_.scene().extensions.empty()) calls_->meeting.here |= 1u << duringStep;
  addHooks();
  together("thaw.Simulation", [&](SharedFailure& failure) {
    return failure = shareFailure(*calls_, sim_.communicator()), true;
  });
}

void PythonSimulation::addHooks() {
  functions_.resize(kinds);
  sim_.onStep([this] { callAll(afterStep); });
  sim_.onFrame([this] { callAll(afterFrame); });
  sim_.onEnd([this] { callAll(atEnd); });
  for (std::size_t k = 0; k < hookPhaseNames.size(); k++)
    sim_.onPhase(static_cast<HookPhase>(k), [this, k] { callAll(afterPhase + k); });
}

void PythonSimulation::callAll(std::size_t kind) {
  for (std::size_t k = 0; k < functions_[kind].size(); k++) {
    const std::function<void()> call = functions_[kind][k];  // a function may add others
    call();
  }
  if (calls_->meeting.onAny >> kind & 1) meetAtEnd(calls_->meeting);
}

void PythonSimulation::keep(std::size_t kind, std::function<void()> call) {
  refuseOtherThread();
  calls_->meeting.here |= 1u << kind;
  functions_[kind].push_back(std::move(call));
}

PythonSimulation::~PythonSimulation() { calls_->arrays.releaseFromEnd(); }

void PythonSimulation::refuseOtherThread() const {
  if (busy_ != std::thread::id() && busy_ != std::this_thread::get_id())
    throw std::runtime_error("another thread is stepping this simulation; wait until it has ended");
}

void PythonSimulation::refuseChange(const char* what) const {
  refuseOtherThread();
  if (blocks_ > 0)
    throw std::runtime_error(std::string(what) +
                             ": not possible in a block `with sim.local()`; end it first");
  if (sim_.busy() || calls_->depth > 0)
    throw std::runtime_error(std::string(what) +
                             ": not possible within a step; do it after sim.run() or sim.step()");
}

void PythonSimulation::requireFolder(const char* what) const {
  if (!sim_.writes())
    throw std::runtime_error(
        std::string(what) +
        ": the simulation has no folder; give one, as thaw.Simulation(scene, \"out/run\")");
}

void PythonSimulation::endRun(const SharedFailure& failure) {
  if (!sim_.busy()) sim_.resume();
  throwFailure(*calls_, failure);
}

void PythonSimulation::lookForSignals() {
  if (stopRequested_.exchange(false)) sim_.requestStop();
  const py::gil_scoped_acquire python;
  if (!calls_->failed && PyErr_CheckSignals() != 0) calls_->failed.emplace();
  if (calls_->failed) sim_.requestStop();  // for other ranks
}

bool PythonSimulation::tryStep(bool share, SharedFailure& failure) {
  const MPI_Comm comm = sim_.communicator();
  bool stepped = false;
  try {
    stepped = sim_.step();
  } catch (const BlewUp&) {  // on all ranks; a failed function of the program may be the cause
    failure = shareFailure(*calls_, comm);
    if (failure) return false;
    throw;
  }
  lookForSignals();
  if (share || sim_.stopped() || !stepped || (sim_.ranks() == 1 && calls_->failed))
    failure = shareFailure(*calls_, comm);
  if (failure.interrupt && sim_.writes()) sim_.writeCheckpoint();
  return stepped && !failure;
}

bool PythonSimulation::step() {
  refuseChange("step");
  return together("sim.step", [&](SharedFailure& failure) { return tryStep(sim_.ranks() > 1, failure); });
}

namespace {

/// Sets the end of the simulation during its life, then the end of the scene again.
class TemporaryEnd {
 public:
  TemporaryEnd(Simulation& sim, double end) : sim_(sim) { sim_.setEnd(end); }
  ~TemporaryEnd() { sim_.setEnd(sim_.scene().end); }
  TemporaryEnd(const TemporaryEnd&) = delete;
  TemporaryEnd& operator=(const TemporaryEnd&) = delete;

 private:
  Simulation& sim_;
};

}  // namespace

void PythonSimulation::run(std::optional<double> until, std::optional<std::int64_t> steps,
                           const py::object& progress) {
  using Clock = std::chrono::steady_clock;
  refuseChange("run");
  const double last = until.value_or(end());
  const auto show = [&] {
    if (!progress.is_none()) guarded([&] { progress(sim_.time(), last, sim_.steps()); });
  };
  auto shown = Clock::now();
  std::int64_t left = steps.value_or(INT64_MAX);
  together("sim.run", [&](SharedFailure& failure) {
    const TemporaryEnd temporary(sim_, last);
    const bool share = sim_.ranks() > 1 && calls_->meeting.onAny != 0;
    while (left-- > 0 && tryStep(share, failure)) {
      if (Clock::now() - shown < std::chrono::seconds(1)) continue;
      show();
      shown = Clock::now();
    }
    if (!failure) show();
    return true;
  });
}

int PythonSimulation::finish() {
  refuseChange("finish");
  return together("sim.finish", [&](SharedFailure& failure) {
    const int code = sim_.finish();
    failure = shareFailure(*calls_, sim_.communicator());
    return code;
  });
}

void PythonSimulation::restore() {
  refuseChange("restore");
  requireFolder("restore");
  together("sim.restore", [&](SharedFailure& failure) {
    calls_->arrays.release();
    sim_.restore();
    calls_->meeting.comm = sim_.communicator();
    failure = shareFailure(*calls_, sim_.communicator());
    return true;
  });
}

std::pair<std::vector<std::string>, py::array_t<double>> PythonSimulation::history() const {
  const LedgerHistory& h = sim().history();
  py::array_t<double> values({h.rows.size(), h.names.size()});
  double* to = values.mutable_data();
  for (const LedgerHistory::Row& row : h.rows) to = std::copy(row.values.begin(), row.values.end(), to);
  return {h.names, values};
}

namespace {

using Ledgers = std::map<std::string, double>;

void addVector(Ledgers& to, const std::string& name, const Vec3d& v) {
  for (int a = 0; a < 3; a++) to[name + "_" + "xyz"[a]] = v[a];
}

/// Adds the sums over particles that entered through openings or left through open sides.
void addFlow(Ledgers& to, const std::string& name, const Balance& flow) {
  to[name + "_mass"] = flow.mass;
  to[name + "_kinetic"] = flow.kinetic;
  to[name + "_elastic"] = flow.elastic;
  to[name + "_potential"] = flow.potential;
  to[name + "_internal"] = flow.internal;
  addVector(to, name + "_momentum", flow.momentum);
}

}  // namespace

std::map<std::string, double> PythonSimulation::ledger() {
  LedgerReport l;
  together("sim.ledger", [&](SharedFailure&) { return l = sim_.ledger(), true; });
  Ledgers all{{"time", sim_.time()},
              {"mass", l.now.mass},
              {"kinetic", l.now.kinetic},
              {"elastic", l.now.elastic},
              {"potential", l.now.potential},
              {"internal", l.now.internal},
              {"dissipated", l.dissipated},
              {"outside_work", l.wallWork},
              {"wall_work", l.wallWork},
              {"heat_in", l.heatIn},
              {"phase_jump", l.phaseJump},
              {"restart_jump", l.restartJump},
              {"energy_residual", l.energyResidual},
              {"energy_scale", l.energyLargest},
              {"heat_residual", l.heatResidual},
              {"heat_scale", l.heatScale},
              {"mass_residual", l.massResidual},
              {"liquid_fraction", l.liquidFraction},
              {"particles", static_cast<double>(l.particles)}};
  addVector(all, "momentum", l.now.momentum);
  addVector(all, "momentum_residual", l.momentumResidual);
  addVector(all, "angular_momentum", l.now.angularMomentum);
  addVector(all, "wall_impulse", l.wallImpulse);
  addVector(all, "gravity_impulse", l.gravityImpulse);
  addFlow(all, "entered", l.entered);
  addFlow(all, "left", l.left);
  return all;
}

std::vector<std::string> PythonSimulation::tables() {
  const Modules& m = sim().world().modules;
  std::vector<std::string> names{"particles"};
  if (m.solid) names.emplace_back("solids");
  if (m.surface) names.emplace_back("surfels");
  if (m.oriented) names.emplace_back("oriented");
  if (m.sheet) names.emplace_back("sheets");
  return names;
}

Table& PythonSimulation::tableOf(const std::string& name) {
  World& w = sim().world();
  if (name == "particles") return w.particles;
  if (name == "solids") return w.solids;
  if (name == "surfels") return w.surface.surfels;
  if (name == "oriented") return w.oriented.rows;
  if (name == "sheets") return w.sheets.rows;
  throw py::key_error("unknown table '" + name + "'");
}

std::size_t PythonSimulation::rows(const std::string& table) { return tableOf(table).owned; }

std::vector<FieldNote> PythonSimulation::fields(const std::string& table) { return notesOf(tableOf(table)); }

py::array PythonSimulation::view(const std::string& table, const std::string& field, bool writable) {
  if (blocks_ == 0) throw std::runtime_error("rows are valid in a block `with sim.local()` only");
  Table& rows = tableOf(table);
  AnyColumn& column = columnOf(rows, field);
  return calls_->arrays.of(column, rows.owned, writable || isAdded(rows, column));
}

py::array PythonSimulation::gather(const std::string& table, const std::string& field) {
  const Table& t = tableOf(table);
  AnyColumn &id = columnOf(tableOf(table), "id"), &column = columnOf(tableOf(table), field);
  std::vector<std::byte> ids, values;
  together("sim.gather('" + field + "')", [&](SharedFailure&) {
    ids = allRows(sim_.communicator(), id.bytes.data(), t.owned * id.elementBytes);
    values = allRows(sim_.communicator(), column.bytes.data(), t.owned * column.elementBytes);
    return true;
  });
  std::vector<std::uint64_t> key(ids.size() / 8);
  std::memcpy(key.data(), ids.data(), ids.size());
  std::vector<std::size_t> order(key.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return key[a] < key[b]; });
  std::vector<py::ssize_t> shape{static_cast<py::ssize_t>(key.size())};
  if (column.components > 1) shape.push_back(column.components);
  py::array result(typeOf(column.scalar), shape);
  auto* to = static_cast<std::byte*>(result.mutable_data());
  for (std::size_t k = 0; k < order.size(); k++)
    std::memcpy(to + k * column.elementBytes, values.data() + order[k] * column.elementBytes,
                column.elementBytes);
  return result;
}

void PythonSimulation::beginBlock(const std::string& table, bool edit) {
  tableOf(table);  // throws for an unknown one
  if (calls_->depth > 0)
    throw std::runtime_error(
        "sim.local(): not possible in a function that is called within a step; it gets its rows");
  if (edit) sim_.beginEdit();
  blocks_++;
}

void PythonSimulation::endBlock(bool edit) {
  refuseOtherThread();
  blocks_--;
  calls_->arrays.release();
  if (!edit) return;
  together("the end of sim.local()", [&](SharedFailure& failure) {
    const bool changed = sim_.endEdit();
    if (changed && !sim_.busy()) failure = shareFailure(*calls_, sim_.communicator());
    return changed;
  });
}

void PythonSimulation::writeFrame() {
  refuseOtherThread();
  if (blocks_ > 0) refuseChange("write_frame");
  requireFolder("write_frame");
  together("sim.write_frame", [&](SharedFailure& failure) {
    sim_.writeFrame();  // with functions of on_frame
    if (!sim_.busy()) failure = shareFailure(*calls_, sim_.communicator());
    return true;
  });
}

void PythonSimulation::writeCheckpoint() {
  refuseOtherThread();
  if (blocks_ > 0) refuseChange("write_checkpoint");
  requireFolder("write_checkpoint");
  together("sim.write_checkpoint", [&](SharedFailure&) { return sim_.writeCheckpoint(), true; });
}

void PythonSimulation::onStep(const py::function& call) {
  keep(afterStep, [f = keepFunction(call)] { guarded([&] { (*f)(); }); });
}

void PythonSimulation::onFrame(const py::function& call) {
  keep(afterFrame, [f = keepFunction(call)] { guarded([&] { (*f)(); }); });
}

void PythonSimulation::onPhase(const std::string& phase, const py::function& call) {
  const auto at = std::find(hookPhaseNames.begin(), hookPhaseNames.end(), phase);
  if (at == hookPhaseNames.end()) {
    std::string names;
    for (const std::string_view name : hookPhaseNames)
      names += (names.empty() ? "" : ", ") + std::string(name);
    throw std::invalid_argument("unknown phase '" + phase + "'; a step has " + names);
  }
  keep(afterPhase + static_cast<std::size_t>(at - hookPhaseNames.begin()), [this, f = keepFunction(call)] {
    guarded([&] { callWithRows(f, sim_.world().particles, sim_.time()); });
  });
}

void PythonSimulation::onEnd(const py::function& call) {
  keep(atEnd, [f = keepFunction(call)] { guarded([&] { (*f)(); }); });
}

void PythonSimulation::addLoad(const py::function& call) {
  refuseChange("add_force");
  calls_->meeting.here |= 1u << duringStep;
  together("sim.add_force", [&, f = keepFunction(call)](SharedFailure& failure) {
    sim_.addForce([this, f](const OutsideLoad& load) {
      guarded([&] { callLoad(f, load); });
      meetAtEnd(calls_->meeting);
    });
    failure = shareFailure(*calls_, sim_.communicator());
    return true;
  });
}

ObstacleLoad PythonSimulation::loadOf(const DrivenObstacle& obstacle) {
  ObstacleLoad load;
  together("obstacle.load", [&](SharedFailure&) { return load = obstacle.load(), true; });
  return load;
}

}  // namespace thaw::python
