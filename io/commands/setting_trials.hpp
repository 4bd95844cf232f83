// Settings that `thaw check` recommends, tried on the scene before they are printed.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "core/scene/scene.hpp"
#include "parallel/communicator.hpp"

namespace thaw {

/// A scene file with overrides, as `thaw check` got them, and its particles at the start.
struct TriedScene {
  std::string path;
  std::vector<std::string> overrides;
  double particles = 0;
};

/// Short runs of a scene with settings, in memory, on all ranks. Particles times steps are bounded, and the
/// time of all runs; a scene that is too large for that is not tried.
class SettingTrials {
 public:
  SettingTrials(const Communicator& comm, TriedScene scene);
  /// Steps of each run; 0: the scene is too large.
  int steps() const { return steps_; }
  /// "" if the scene with these settings ("key=value") runs as well as it does without; else what went wrong.
  /// No value: not tried, for want of time. Collective, the same answer on all ranks.
  std::optional<std::string> failureOf(const std::vector<std::string>& settings);

 private:
  /// What one run came to.
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
  std::optional<Result> usual_;  // without any setting
};

}  // namespace thaw
