// SPDX-License-Identifier: Apache-2.0
// Wall-clock time (s) of the phases of surface updates on this rank. No result depends on it.
#pragma once
#include <array>
#include <chrono>
#include <cstddef>

namespace thaw {

/// Phases of an update. Place: particle copies and migration. Displacement: gradients and displacement.
enum class SurfacePhase : std::size_t {
  Place,
  Displacement,
  Components,
  Fields,
  Growth,
  Resampling,
  Iterations,
  Measures
};
inline constexpr std::size_t surfacePhases = 8;

inline const char* phaseName(SurfacePhase phase) {
  constexpr const char* names[surfacePhases] = {"place",  "displacement", "components", "fields",
                                                "growth", "resampling",   "iterations", "measures"};
  return names[static_cast<std::size_t>(phase)];
}

struct SurfaceTimes {
  using Clock = std::chrono::steady_clock;
  std::array<double, surfacePhases> seconds{};
  Clock::time_point since{};

  double operator[](SurfacePhase phase) const { return seconds[static_cast<std::size_t>(phase)]; }
  void start() { since = Clock::now(); }
  /// Adds the time since the last call to a phase.
  void lap(SurfacePhase phase) {
    const auto now = Clock::now();
    seconds[static_cast<std::size_t>(phase)] += std::chrono::duration<double>(now - since).count();
    since = now;
  }
};

}  // namespace thaw
