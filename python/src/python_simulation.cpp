// SPDX-License-Identifier: Apache-2.0
#include "python/src/python_simulation.hpp"

#include <pybind11/stl.h>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <numeric>

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
  o.out = text("out");
  o.restart = !text("restart").empty();
  o.resume = !text("resume").empty();
  o.force = !text("force").empty();
  if (const std::string limit = text("time_limit"); !limit.empty()) o.timeLimit = std::stod(limit);
  if (const std::string every = text("report_every"); !every.empty()) o.reportEvery = std::stod(every);
  for (const auto& [key, value] : given)
    if (key.rfind("set ", 0) == 0) o.overrides.push_back(key.substr(4) + "=" + value);
  if (!log.is_none())
    o.log = [call = py::function(log)](const std::string& line) {
      const py::gil_scoped_acquire python;
      call(line);
    };
  return o;
}

Simulation make(const std::string& text, RunOptions options, std::optional<int> comm) {
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

}  // namespace

PythonSimulation::PythonSimulation(const std::string& text, const Options& options, const py::object& log,
                                   std::optional<int> comm)
    : sim_(make(text, runOptions(options, log), comm)) {}

void PythonSimulation::refuseArrays(const char* what) const {
  if (*count_ > 0)
    throw std::runtime_error(
        std::string(what) + ": " + std::to_string(*count_) +
        " arrays of this simulation are still in use; delete them, or copy their values");
}

void PythonSimulation::lookForSignals() {
  const py::gil_scoped_acquire python;
  if (failed_ || PyErr_CheckSignals() == 0) return;
  failed_.emplace();
  sim_.requestStop();
}

/// Takes a step. Returns nothing if a function of the program, or a signal, ended it: `failed_` is then set.
std::optional<bool> PythonSimulation::tryStep() {
  const bool stepped = sim_.step();
  lookForSignals();
  // With several ranks the others stop after their next step, which this rank takes, too.
  if (failed_ && (sim_.ranks() == 1 || sim_.stopped() || !stepped)) return std::nullopt;
  return stepped;
}

bool PythonSimulation::step() {
  refuseArrays("step");
  std::optional<bool> stepped;
  {
    const py::gil_scoped_release others;
    do stepped = tryStep();
    while (stepped && failed_);
  }
  if (failed_) {
    py::error_already_set error = std::move(*failed_);
    failed_.reset();
    sim_.resume();
    throw error;
  }
  return stepped.value_or(false);
}

void PythonSimulation::run(std::optional<double> until, std::optional<std::int64_t> steps,
                           const py::object& progress) {
  using Clock = std::chrono::steady_clock;
  refuseArrays("run");
  const auto show = [&] {
    const py::gil_scoped_acquire python;
    progress(sim_.time(), until.value_or(end()), sim_.steps());
  };
  auto shown = Clock::now();
  const double last = until.value_or(end());
  std::int64_t left = steps.value_or(INT64_MAX);
  {
    const py::gil_scoped_release others;
    sim_.setEnd(last);
    while (left-- > 0 && tryStep().value_or(false)) {
      if (progress.is_none() || Clock::now() - shown < std::chrono::seconds(1)) continue;
      show();
      shown = Clock::now();
    }
    sim_.setEnd(end());
  }
  if (!progress.is_none()) show();
  if (!failed_) return;
  py::error_already_set error = std::move(*failed_);
  failed_.reset();
  sim_.resume();
  throw error;
}

int PythonSimulation::finish() {
  refuseArrays("finish");
  int code = 0;
  {
    const py::gil_scoped_release others;
    code = sim_.finish();
  }
  if (failed_) {  // a function of on_end raised it
    py::error_already_set error = std::move(*failed_);
    failed_.reset();
    throw error;
  }
  return code;
}

std::map<std::string, double> PythonSimulation::ledger() {
  const LedgerReport l = sim_.ledger();
  return {{"mass", l.now.mass},
          {"kinetic", l.now.kinetic},
          {"elastic", l.now.elastic},
          {"potential", l.now.potential},
          {"internal", l.now.internal},
          {"dissipated", l.dissipated},
          {"outside_work", l.wallWork},
          {"heat_in", l.heatIn},
          {"phase_jump", l.phaseJump},
          {"energy_residual", l.energyResidual},
          {"energy_scale", l.energyLargest},
          {"heat_residual", l.heatResidual},
          {"heat_scale", l.heatScale},
          {"mass_residual", l.massResidual},
          {"momentum_x", l.now.momentum.x},
          {"momentum_y", l.now.momentum.y},
          {"momentum_z", l.now.momentum.z},
          {"liquid_fraction", l.liquidFraction},
          {"particles", static_cast<double>(l.particles)}};
}

std::vector<std::string> PythonSimulation::tables() {
  const Modules& m = sim_.world().modules;
  std::vector<std::string> names{"particles"};
  if (m.solid) names.emplace_back("solids");
  if (m.surface) names.emplace_back("surfels");
  if (m.oriented) names.emplace_back("oriented");
  if (m.sheet) names.emplace_back("sheets");
  return names;
}

Table& PythonSimulation::tableOf(const std::string& name) {
  World& w = sim_.world();
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
  Table& rows = tableOf(table);
  AnyColumn& column = columnOf(rows, field);
  return arrayOf(column, rows.owned, writable || isAdded(rows, column), count_);
}

py::array PythonSimulation::gather(const std::string& table, const std::string& field) {
  const Table& t = tableOf(table);
  AnyColumn &id = columnOf(tableOf(table), "id"), &column = columnOf(tableOf(table), field);
  std::vector<std::byte> ids, values;
  {
    const py::gil_scoped_release others;
    ids = allRows(sim_.communicator(), id.bytes.data(), t.owned * id.elementBytes);
    values = allRows(sim_.communicator(), column.bytes.data(), t.owned * column.elementBytes);
  }
  std::vector<std::uint64_t> key(ids.size() / 8);
  std::memcpy(key.data(), ids.data(), ids.size());
  std::vector<std::size_t> order(key.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return key[a] < key[b]; });
  const py::array model = arrayOf(column, 0, false, count_);  // for its type
  std::vector<py::ssize_t> shape{static_cast<py::ssize_t>(key.size())};
  if (column.components > 1) shape.push_back(column.components);
  py::array result(model.dtype(), shape);
  auto* to = static_cast<std::byte*>(result.mutable_data());
  for (std::size_t k = 0; k < order.size(); k++)
    std::memcpy(to + k * column.elementBytes, values.data() + order[k] * column.elementBytes,
                column.elementBytes);
  return result;
}

bool PythonSimulation::endEdit() {
  const py::gil_scoped_release others;
  return sim_.endEdit();
}

void PythonSimulation::writeFrame() {
  const py::gil_scoped_release others;
  sim_.writeFrame();
}

void PythonSimulation::writeCheckpoint() {
  const py::gil_scoped_release others;
  sim_.writeCheckpoint();
}

namespace {

/// Calls a function of the program. Its error is kept: the step has to end first.
template<class Call>
void guarded(std::optional<py::error_already_set>& failed, Simulation& sim, const Call& call) {
  const py::gil_scoped_acquire python;
  if (failed) return;
  try {
    call();
  } catch (py::error_already_set& e) {
    failed = std::move(e);
    sim.requestStop();
  }
}

}  // namespace

void PythonSimulation::onStep(const py::function& call) {
  sim_.onStep([this, call] { guarded(failed_, sim_, [&] { call(); }); });
}

void PythonSimulation::onFrame(const py::function& call) {
  sim_.onFrame([this, call] { guarded(failed_, sim_, [&] { call(); }); });
}

void PythonSimulation::onPhase(const std::string& phase, const py::function& call) {
  const auto at = std::find(hookPhaseNames.begin(), hookPhaseNames.end(), phase);
  if (at == hookPhaseNames.end()) {
    std::string names;
    for (const std::string_view name : hookPhaseNames)
      names += (names.empty() ? "" : ", ") + std::string(name);
    throw std::invalid_argument("unknown phase '" + phase + "'; a step has " + names);
  }
  sim_.onPhase(static_cast<HookPhase>(at - hookPhaseNames.begin()), [this, call] {
    guarded(failed_, sim_, [&] { callWithRows(call, sim_.world().particles, count_, sim_.time()); });
  });
}

void PythonSimulation::onEnd(const py::function& call) {
  sim_.onEnd([this, call] { guarded(failed_, sim_, [&] { call(); }); });
}

void PythonSimulation::addLoad(const py::function& call) {
  sim_.addForce([this, call](const OutsideLoad& load) {
    guarded(failed_, sim_, [&] { callLoad(call, load, count_); });
  });
}

}  // namespace thaw::python
