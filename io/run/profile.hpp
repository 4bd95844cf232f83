// `thaw run --profile`: where the time of the steps goes on each rank, and what is sent; a table for the
// terminal and a trace.
#pragma once
#include <chrono>
#include <string>
#include <vector>

#include "core/time/phase_times.hpp"
#include "io/run/traffic_summary.hpp"
#include "parallel/communicator.hpp"

namespace thaw {

/// What was measured before the first step, and the trace since then.
struct Profile {
  explicit Profile(std::size_t steps) : trace(steps) {}
  StepTrace trace;
  PhaseTimes times;  ///< before the first step
  Traffic traffic;
  std::chrono::steady_clock::time_point start{};
};

/// Measures from here on. The profile must outlive both, or be taken from them by endProfile.
void beginProfile(Profile& profile, PhaseTimes& times, const Communicator& comm);
void endProfile(PhaseTimes& times, const Communicator& comm);

/// The table: seconds of each phase, least, mean and most of the ranks, then messages, bytes and waiting by
/// purpose, a step. Collective; the same on all ranks.
std::vector<std::string> profileLines(const Profile& profile, const PhaseTimes& times, std::int64_t steps,
                                      std::int64_t particles, const Communicator& comm);

}  // namespace thaw
