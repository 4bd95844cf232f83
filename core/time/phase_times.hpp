// SPDX-License-Identifier: Apache-2.0
// Wall-clock time of a run by phase. Nested timers do not count twice: an inner timer pauses the outer one.
#pragma once
#include <array>
#include <chrono>
#include <cstddef>
#include <ctime>

#include "core/time/step_trace.hpp"

namespace thaw {

/// Phases of a step and of a run. None: time without a timer.
enum class StepPhase : std::size_t {
  Setup,
  Drift,
  Domain,
  Migrate,
  Sort,
  Search,
  Density,
  Forces,
  Viscosity,
  Walls,
  Contact,
  Elastic,
  Bonds,
  Heat,
  Phase,
  Kick,
  Exchange,
  Reduce,
  Pressure,
  Surface,
  Oriented,
  SheetMotion,
  Sheet,
  SheetContact,
  Balance,
  Frames,
  Checkpoint,
  Other,
  None
};
inline constexpr std::size_t stepPhases = static_cast<std::size_t>(StepPhase::None);

/// Name of a phase in summaries and progress lines.
inline const char* phaseName(StepPhase phase) {
  constexpr const char* names[stepPhases + 1] = {
      "setup",    "drift",   "domain",       "migrate",      "sort",     "search",
      "density",  "forces",  "viscosity",    "walls",        "contact",  "elastic",
      "bonds",    "heat",    "phase_change", "kick",         "exchange", "reduce",
      "pressure", "surface", "oriented",     "sheet_motion", "sheet",    "sheet_contact",
      "balance",  "frames",  "checkpoint",   "other",        "none"};
  return names[static_cast<std::size_t>(phase)];
}

/// Seconds spent in each phase on this rank, and the current phase.
struct PhaseTimes {
  using Clock = std::chrono::steady_clock;
  std::array<double, stepPhases> seconds{};
  StepPhase current = StepPhase::None;
  Clock::time_point since{};
  StepTrace* trace = nullptr;  ///< records laps; null: off
  bool onCore = false;         ///< measures the CPU time of this thread, for ranks that share cores

  double& operator[](StepPhase phase) { return seconds[static_cast<std::size_t>(phase)]; }
  double operator[](StepPhase phase) const { return seconds[static_cast<std::size_t>(phase)]; }
  double total() const {
    double sum = 0;
    for (double s : seconds) sum += s;
    return sum;
  }

  Clock::time_point now() const {
    if (!onCore) return Clock::now();
    timespec t;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return Clock::time_point(std::chrono::seconds(t.tv_sec) + std::chrono::nanoseconds(t.tv_nsec));
  }

  /// For sequential code: time before start() is not counted; lap() adds the time since the last lap to a
  /// phase.
  void start() { since = now(); }
  void lap(StepPhase phase) {
    const auto end = now();
    (*this)[phase] += std::chrono::duration<double>(end - since).count();
    if (trace != nullptr) trace->add(TraceKind::Phase, static_cast<std::uint8_t>(phase), since, end);
    since = end;
  }

  /// Adds the time since the last call to the current phase and makes `next` current. Returns the former
  /// phase.
  StepPhase change(StepPhase next) {
    const Clock::time_point end = now();
    const StepPhase before = current;
    if (before != StepPhase::None) (*this)[before] += std::chrono::duration<double>(end - since).count();
    since = end;
    current = next;
    return before;
  }
};

/// Times its own scope as `phase`; afterwards the former phase continues.
class PhaseTimer {
 public:
  PhaseTimer(PhaseTimes& times, StepPhase phase) : times_(times), before_(times.change(phase)) {}
  ~PhaseTimer() { times_.change(before_); }
  PhaseTimer(const PhaseTimer&) = delete;
  PhaseTimer& operator=(const PhaseTimer&) = delete;

 private:
  PhaseTimes& times_;
  StepPhase before_;
};

}  // namespace thaw
