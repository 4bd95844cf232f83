// SPDX-License-Identifier: Apache-2.0
// A simulation as a program sees it: made from a scene, stepped, read, changed, written. It does
// everything that `thaw run` does, except printing. `thaw run` itself uses it.
//
//   thaw::MpiSession mpi(&argc, &argv);
//   thaw::Simulation sim({.scene = "melt.toml", .out = "out/melt"});
//   sim.run();
//
// All functions but the const ones are collective: every rank of the communicator calls them in the same
// order. Simulations are independent of each other.
//
// Units are SI, temperatures K. Equations and their sources: docs/theory/index.md. Steps are kick-drift-kick
// leap-frog (SP05).
#pragma once
#include <mpi.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/simulation/ledger/report.hpp"
#include "core/simulation/workspace/step_hooks.hpp"
#include "core/simulation/world/world.hpp"
#include "core/terms/outside_forces.hpp"
#include "io/run/run_options.hpp"

namespace thaw {

struct LedgerHistory;
struct Run;
class Communicator;

/// A step failed, and the retries of the scene are used up. what(): the particle, the cause and the retries.
struct BlewUp : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A simulation on the ranks of one communicator. Errors of scenes are SceneErrors (with file, line and
/// column) or ShapeError, errors of files IoError, alike on all ranks. Calls at a wrong time, such as within
/// a step, throw std::logic_error.
class Simulation {
 public:
  /// Reads the scene file `options.scene` and makes its particles, or continues from the checkpoint in
  /// `options.out` with options.restart or resume. If there is a folder, locks it and writes the first frame.
  /// Throws SceneErrors, ShapeError, IoError or std::runtime_error, alike on all ranks.
  explicit Simulation(RunOptions options, MPI_Comm comm = MPI_COMM_WORLD);
  /// The same with a scene that the program made or changed, equal on all ranks. options.scene is a name for
  /// messages and files, "scene" by default. A restart compares the scene with that of the checkpoint. Throws
  /// SceneErrors for values out of the ranges of scene files, and for references to missing materials.
  Simulation(Scene scene, RunOptions options, MPI_Comm comm = MPI_COMM_WORLD);
  /// The same with the text of a scene file (TOML), equal on all ranks. Paths are relative to the working
  /// folder.
  static Simulation fromText(const std::string& text, RunOptions options, MPI_Comm comm = MPI_COMM_WORLD);
  ~Simulation();
  Simulation(Simulation&&) noexcept;
  Simulation& operator=(Simulation&&) noexcept;

  /// Takes one step, with the surface, frames, ledger rows and checkpoints that are due after it. If the step
  /// fails and a retry is left, the simulation goes back to its last snapshot. At the end of the scene, and
  /// after a stop request (signal, stop file, time limit), takes no step and returns false. Throws BlewUp,
  /// IoError, and std::logic_error within a step or an edit.
  bool step();
  /// Steps to the end of the scene, or to a stop request. Throws as step() does, like the other runs.
  void run();
  /// Sets the time (s) that the next steps lead to.
  void setEnd(double time);
  /// Steps to a time (s), which may be beyond the end of the scene. The last steps are shortened to hit it.
  void runUntil(double time);
  /// Takes a number of steps, fewer at the end of the scene.
  void runSteps(std::int64_t count);
  /// Writes the last checkpoint and the summary of a run with a folder. No step may follow. Returns the exit
  /// code of `thaw run` (docs/reference/exit_codes.md). Throws as step() does.
  int finish();
  /// Returns true after a stop request; stopReason() names its cause.
  bool stopped() const;
  const std::string& stopReason() const;

  double time() const;         ///< s
  double lastStep() const;     ///< s, length of the last step
  std::int64_t steps() const;  ///< steps since the start of the scene
  const Scene& scene() const;  ///< with all defaults resolved
  const World& world() const;  ///< particles, surface, sheets, oriented bodies of this rank
  World& world();              ///< changes made through it are not in the ledger
  /// Tables of this rank, each with columns that have name, unit and meaning; empty where the scene has none.
  const Continuum& particles() const;
  const Surfels& surfels() const;
  const Sheets& sheets() const;
  const Oriented& oriented() const;
  bool writes() const;            ///< true if it has a folder
  bool busy() const;              ///< true within a step, while a function of the program runs
  MPI_Comm communicator() const;  ///< the simulation's own
  const std::vector<std::string>& warnings() const;  ///< on the first rank
  int rank() const;
  int ranks() const;

  /// Returns the ledger over all ranks: energies and work (J), momentum (kg m/s), mass (kg), and their
  /// residuals (core/simulation/ledger/report.hpp).
  LedgerReport ledger();
  /// Rows of the ledger at the start, each frame and each output.ledger_every. Throws
  /// std::logic_error without RunOptions::history.
  const LedgerHistory& history() const;
  /// Updates the surface to the current time. Requires: the scene has one.
  void updateSurface();
  /// Writes a frame or a checkpoint now. Throws IoError, and std::logic_error without a folder or within an
  /// edit. A checkpoint needs complete steps.
  void writeFrame();
  void writeCheckpoint();
  /// Goes back to the newest checkpoint in the folder, as a restart does. Keeps all functions that were
  /// added. Driven obstacles must be constructed again. If it throws (SceneErrors if there is no checkpoint,
  /// IoError), the simulation is unchanged. Throws std::logic_error without a folder.
  void restore();

  /// Functions that are called after every step, and after every frame. They are called again for steps that
  /// a retry repeats.
  void onStep(std::function<void()> call);
  void onFrame(std::function<void()> call);
  /// Adds a function that is called after a phase of every step, on all ranks. The evaluations at
  /// the start and after edits call it too, for the phases that they run. It may read all fields that the
  /// phase has set, and write fields of extensions from a row's own fields. Rows move in
  /// HookPhase::Redistribute. Throws std::out_of_range for an unknown phase.
  void onPhase(HookPhase phase, std::function<void()> call);
  /// Adds a function that finish() calls before the last checkpoint.
  void onEnd(std::function<void()> call);
  /// Adds a force (N) or a source of heat (W) from now on, as OutsideLoad describes. After a restart, first
  /// add the forces and sources of the earlier run. Its work, impulse and heat are in the ledger. The
  /// automatic sound speed of liquids does not include it: give material.sound_speed, ten times the largest
  /// speed of the flow.
  void addForce(OutsideSource source);
  /// Between beginEdit and endEdit, the program may change Continuum::velocity and temperature of owned rows.
  /// endEdit returns whether some rank changed one; forces and the next step are then computed anew. The
  /// ledger records the change as work, impulse and heat from outside, and retries keep it. No step is
  /// possible during an edit. Both functions throw std::logic_error if called out of order. endEdit throws
  /// std::invalid_argument on all ranks for values that are not finite and for temperatures below 0 K. It
  /// then reverts all changes.
  Continuum& beginEdit();
  bool endEdit();
  /// Requests that all ranks stop after the next step. It suffices to call it on one rank.
  void requestStop();
  /// Lets a simulation go on after a stop request.
  void resume();

 private:
  struct Parts;
  explicit Simulation(std::unique_ptr<Parts> parts);
  bool atEnd() const;
  friend class DrivenObstacle;
  Run& runState();
  std::unique_ptr<Parts> parts_;
};

}  // namespace thaw
