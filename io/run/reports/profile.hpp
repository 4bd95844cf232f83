// SPDX-License-Identifier: Apache-2.0
// `thaw run --profile`: times and messages of the steps on each rank, as a table for the terminal and a
// trace.
#pragma once
#include <chrono>
#include <string>
#include <vector>

#include "core/time/phase_times.hpp"
#include "io/run/reports/communication_summary.hpp"
#include "parallel/communicator.hpp"

namespace thaw {

/// Values before the first step, and the trace since then.
struct Profile {
  explicit Profile(std::size_t steps) : trace(steps) {}
  StepTrace trace;
  PhaseTimes times;  ///< before the first step
  CommunicationStatistics statistics;
  std::chrono::steady_clock::time_point start{};
};

/// Starts the measurement. The profile must outlive both arguments, or be detached by endProfile.
void beginProfile(Profile& profile, PhaseTimes& times, const Communicator& comm);
void endProfile(PhaseTimes& times, const Communicator& comm);

/// Returns the table: time of each phase (smallest, mean, largest over ranks), then messages, bytes and
/// waiting time by purpose, all per step. Collective; the same on all ranks.
std::vector<std::string> profileLines(const Profile& profile, const PhaseTimes& times, std::int64_t steps,
                                      std::int64_t particles, const Communicator& comm);

}  // namespace thaw
