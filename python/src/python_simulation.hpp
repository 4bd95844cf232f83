// SPDX-License-Identifier: Apache-2.0
// A Simulation for Python: it releases the interpreter while it steps, and hands out arrays.
#pragma once
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "io/simulation/simulation.hpp"
#include "python/src/load_rows.hpp"

namespace thaw::python {

/// Keyword options of thaw.Simulation: text values by name; flags are "1".
using Options = std::map<std::string, std::string>;

class PythonSimulation {
 public:
  /// text: TOML, or "" for the file options["scene"]. log: called with each line, or None. comm: a Fortran
  /// handle of a communicator, or nothing for all ranks.
  PythonSimulation(const std::string& text, const Options& options, const pybind11::object& log,
                   std::optional<int> comm);

  bool step();
  /// Steps to a time, for a number of steps, or to the end. progress: called about once a second, or None.
  void run(std::optional<double> until, std::optional<std::int64_t> steps, const pybind11::object& progress);
  int finish();
  void resume() { sim_.resume(); }
  void requestStop() { sim_.requestStop(); }
  bool stopped() const { return sim_.stopped(); }
  std::string stopReason() const { return sim_.stopReason(); }
  double time() const { return sim_.time(); }
  double end() const { return sim_.scene().end; }
  double lastStep() const { return sim_.lastStep(); }
  std::int64_t steps() const { return sim_.steps(); }
  int rank() const { return sim_.rank(); }
  int ranks() const { return sim_.ranks(); }
  std::vector<std::string> warnings() const { return sim_.warnings(); }
  Simulation& simulation() { return sim_; }
  std::map<std::string, double> ledger();

  /// Names of the tables that the scene has: particles, solids, surfels, oriented, sheets.
  std::vector<std::string> tables();
  std::size_t rows(const std::string& table);
  /// (name, unit, meaning, components) of the active fields.
  std::vector<FieldNote> fields(const std::string& table);
  pybind11::array view(const std::string& table, const std::string& field, bool writable);
  /// The field of all ranks, sorted by id. Collective.
  pybind11::array gather(const std::string& table, const std::string& field);
  int arrays() const { return *count_; }
  void beginEdit() { sim_.beginEdit(); }
  bool endEdit();
  void writeFrame();
  void writeCheckpoint();

  void onStep(const pybind11::function& call);
  void onFrame(const pybind11::function& call);
  /// Calls call(rows, time) after a phase of each step. Throws std::invalid_argument for an unknown phase.
  void onPhase(const std::string& phase, const pybind11::function& call);
  void onEnd(const pybind11::function& call);
  /// See callLoad.
  void addLoad(const pybind11::function& call);

 private:
  Table& tableOf(const std::string& name);
  void refuseArrays(const char* what) const;
  /// Notes a pending signal such as Ctrl-C. All ranks then stop after the step.
  void lookForSignals();
  std::optional<bool> tryStep();

  ArrayCount count_ = std::make_shared<int>(0);
  std::optional<pybind11::error_already_set> failed_;  // error of a function of the program, or a signal
  Simulation sim_;
};

}  // namespace thaw::python
