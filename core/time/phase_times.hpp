// Wall-clock time by phase of the step, on this rank.
#pragma once
#include <array>
#include <chrono>

namespace thaw {

enum class StepPhase { Move, Migrate, Sort, Ghosts, Search, Density, Forces, Elastic, Bonds, Contact, Walls, Heat, Reduce, Balance, Output, Count };
inline constexpr std::array<const char*, static_cast<std::size_t>(StepPhase::Count)> stepPhaseNames{
    "move", "migrate", "sort", "exchange", "search", "density", "forces", "elastic", "bonds", "contact", "walls", "heat", "reduce", "balance", "output"};

struct PhaseTimes {
  std::array<double, static_cast<std::size_t>(StepPhase::Count)> seconds{};
  std::chrono::steady_clock::time_point last = std::chrono::steady_clock::now();
  /// What follows is not counted until the next lap.
  void start() { last = std::chrono::steady_clock::now(); }
  /// Adds the time since the last call to a phase.
  void lap(StepPhase phase) {
    const auto now = std::chrono::steady_clock::now();
    seconds[static_cast<std::size_t>(phase)] += std::chrono::duration<double>(now - last).count();
    last = now;
  }
  double total() const {
    double sum = 0;
    for (double s : seconds) sum += s;
    return sum;
  }
};

}  // namespace thaw
