// SPDX-License-Identifier: Apache-2.0
// Trials of the settings that `thaw check` recommends.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "core/scene/scene.hpp"
#include "parallel/communicator.hpp"
#include "parallel/mpi_simulation.hpp"

namespace thaw {

/// A scene file with the overrides of `thaw check`, and its particles at the start.
struct TriedScene {
  std::string path;
  std::vector<std::string> overrides;
  double particles = 0;
};

/// Sets up the scene with further settings ("key=value") and without its surface, which acts on no particle.
/// Oriented bodies are not relaxed first. Throws std::runtime_error on all ranks alike. Collective.
void startTrial(MpiSimulation& simulation, const Communicator& comm, const TriedScene& scene,
                const std::vector<std::string>& settings);

/// Short runs of a scene with settings, in memory, on all ranks. The product of particles and steps is
/// bounded, as is the time of all runs. Too large scenes are not tried.
class SettingTrials {
 public:
  SettingTrials(const Communicator& comm, TriedScene scene);
  /// Steps of each run; 0: the scene is too large.
  int steps() const { return steps_; }
  /// Returns "" if the scene with these settings ("key=value") runs as well as without them, else the
  /// failure. Returns no value if no time is left. Collective, the same result on all ranks.
  std::optional<std::string> failureOf(const std::vector<std::string>& settings);
  /// Returns how the scene itself fails in these steps; empty if it does not, or was not tried.
  std::string failureOfScene() const { return usual_ ? usual_->failure : ""; }

 private:
  /// Result of one run.
  struct Result {
    std::string failure;
    double residual = 0, scale = 0;
    std::int64_t left = 0, particles = 0;
  };
  Result runWith(const std::vector<std::string>& settings);
  bool outOfTime() const;

  const Communicator& comm_;
  TriedScene scene_;
  int steps_ = 0;
  double start_ = 0;             // s
  std::optional<Result> usual_;  // result without settings
};

}  // namespace thaw
