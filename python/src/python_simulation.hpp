// SPDX-License-Identifier: Apache-2.0
// A Simulation for Python: it releases the interpreter while it steps, and hands out arrays.
#pragma once
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <atomic>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "io/simulation/driven_obstacle.hpp"
#include "io/simulation/simulation.hpp"
#include "python/src/load_rows.hpp"

namespace thaw::python {

/// Keyword options of thaw.Simulation: text values by name; flags are "1".
using Options = std::map<std::string, std::string>;

/// All functions throw std::runtime_error while another thread is in one of them. Those that change the
/// simulation throw it within a block of rows and within a function of the program that a step calls.
/// An exception of such a function is thrown at the end of the step on all ranks.
class PythonSimulation {
 public:
  /// text: TOML, or "" for the file options["scene"]. log: called with each line, or None. comm: a Fortran
  /// handle of a communicator, or nothing for all ranks.
  PythonSimulation(const std::string& text, const Options& options, const pybind11::object& log,
                   std::optional<int> comm);
  ~PythonSimulation();
  PythonSimulation(const PythonSimulation&) = delete;
  PythonSimulation& operator=(const PythonSimulation&) = delete;

  bool step();
  /// Steps to a time, for a number of steps, or to the end. progress: called about once a second, or None.
  void run(std::optional<double> until, std::optional<std::int64_t> steps, const pybind11::object& progress);
  int finish();
  void restore();
  /// Throws std::runtime_error if the simulation cannot end now.
  void refuseClose() const { refuseChange("close"); }
  void resume() { sim().resume(); }
  /// Another thread may call it, too.
  void requestStop() { stopRequested_ = true; }
  bool stopped() const { return sim().stopped(); }
  std::string stopReason() const { return sim().stopReason(); }
  double time() const { return sim().time(); }
  double end() const { return sim().scene().end; }
  double lastStep() const { return sim().lastStep(); }
  std::int64_t steps() const { return sim().steps(); }
  int rank() const { return sim().rank(); }
  int ranks() const { return sim().ranks(); }
  std::vector<std::string> warnings() const { return sim().warnings(); }
  Simulation& simulation() { return sim(); }
  /// The force and torque on an obstacle. Collective.
  ObstacleLoad loadOf(const DrivenObstacle& obstacle);
  std::map<std::string, double> ledger();
  /// Names of columns, and the rows of the ledger over time, of shape (rows, columns).
  std::pair<std::vector<std::string>, pybind11::array_t<double>> history() const;

  /// Names of the tables that the scene has: particles, solids, surfels, oriented, sheets.
  std::vector<std::string> tables();
  std::size_t rows(const std::string& table);
  /// (name, unit, meaning, components) of the active fields.
  std::vector<FieldNote> fields(const std::string& table);
  /// Requires: an open block.
  pybind11::array view(const std::string& table, const std::string& field, bool writable);
  /// The field of all ranks, sorted by id. Collective.
  pybind11::array gather(const std::string& table, const std::string& field);
  /// Number of columns of which the program holds arrays.
  int arrays() const { return calls_->arrays.count(); }
  /// Opens a block of rows. edit: velocities and temperatures of particles may be changed.
  void beginBlock(const std::string& table, bool edit);
  /// Ends it, and separates arrays that are still in use.
  void endBlock(bool edit);
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
  class Busy;
  void refuseOtherThread() const;
  void refuseChange(const char* what) const;
  void requireFolder(const char* what) const;
  const Simulation& sim() const { return refuseOtherThread(), sim_; }
  Simulation& sim() { return refuseOtherThread(), sim_; }
  Table& tableOf(const std::string& name);
  /// Runs `work`, in which all ranks meet, without the interpreter's lock. Throws exceptions of functions of
  /// the program afterwards. Throws DifferentCalls if some rank does not call `what`.
  template<class Work> auto together(const std::string& what, const Work& work);
  /// Registers the calls of all kinds of functions. All ranks have them, as they meet after the functions.
  void addHooks();
  /// Calls the functions of a kind, then meets if some rank has such functions.
  void callAll(std::size_t kind);
  void keep(std::size_t kind, std::function<void()> call);
  /// Notes a pending signal such as Ctrl-C. All ranks then stop after the step.
  void lookForSignals();
  /// Takes a step. share: ranks compare their failures afterwards. Otherwise they do so when all have
  /// stopped.
  bool tryStep(bool share, SharedFailure& failure);
  void endRun(const SharedFailure& failure);
  std::unique_ptr<ProgramCalls> calls_ = std::make_unique<ProgramCalls>();
  Simulation sim_;
  std::vector<std::vector<std::function<void()>>> functions_;  // by kind
  int blocks_ = 0;                                             // open blocks of rows
  std::thread::id busy_ = {};  // thread in a function of the simulation; guarded by the interpreter's lock
  std::atomic<bool> stopRequested_ = false;
};

}  // namespace thaw::python
