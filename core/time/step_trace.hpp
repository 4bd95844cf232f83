// SPDX-License-Identifier: Apache-2.0
// Trace of a rank's last steps for `thaw run --profile`: phases, waiting, and exchanges in flight. Its size
// is bounded: it holds the last steps, with a limited number of events each. It does not affect results.
#pragma once
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace thaw {

/// Step: a complete step. Phase: a lap of PhaseTimes. Wait: the rank is blocked. Exchange: messages are in
/// flight, possibly during other work.
enum class TraceKind : std::uint8_t { Step, Phase, Wait, Exchange };

struct TraceEvent {
  std::int64_t begin = 0, end = 0;  ///< ns, by this process's steady clock
  std::int64_t step = 0;
  std::int64_t bytes = 0;     ///< sent, for an exchange
  std::int32_t messages = 0;  ///< sent, for an exchange
  TraceKind kind = TraceKind::Step;
  std::uint8_t name = 0;  ///< a StepPhase, or a MessagesFor value (parallel/communication_statistics.hpp)
};

class StepTrace {
 public:
  using Clock = std::chrono::steady_clock;
  static constexpr std::size_t mostOfAStep = 1 << 14;

  /// Keeps the last `steps` steps (at least 1).
  explicit StepTrace(std::size_t steps) : ring_(steps > 0 ? steps : 1) {}

  /// Starts a step; the oldest one is dropped.
  void beginStep(std::int64_t step) {
    step_ = step;
    begun_ = true;
    at_ = (at_ + 1) % ring_.size();
    dropped_ -= ring_[at_].dropped;
    ring_[at_].dropped = 0;
    ring_[at_].events.clear();
  }

  /// Adds an event. Events before the first step are ignored.
  void add(TraceKind kind, std::uint8_t name, Clock::time_point begin, Clock::time_point end,
           std::int64_t messages = 0, std::int64_t bytes = 0) {
    if (!begun_) return;
    OneStep& now = ring_[at_];
    if (now.events.size() == mostOfAStep) {
      now.dropped++;
      dropped_++;
      return;
    }
    now.events.push_back({nanoseconds(begin), nanoseconds(end), step_, bytes,
                          static_cast<std::int32_t>(messages), kind, name});
  }

  /// Returns the events of the kept steps, oldest first; within a step ordered by end.
  std::vector<TraceEvent> events() const {
    std::vector<TraceEvent> all;
    for (std::size_t k = 1; k <= ring_.size(); k++) {
      const std::vector<TraceEvent>& one = ring_[(at_ + k) % ring_.size()].events;
      all.insert(all.end(), one.begin(), one.end());
    }
    return all;
  }
  /// Number of events of the kept steps that exceeded the limit.
  std::int64_t dropped() const { return dropped_; }

  static std::int64_t nanoseconds(Clock::time_point t) {
    return std::chrono::duration_cast<std::chrono::nanoseconds>(t.time_since_epoch()).count();
  }

 private:
  struct OneStep {
    std::vector<TraceEvent> events;
    std::int64_t dropped = 0;
  };
  std::vector<OneStep> ring_;
  std::size_t at_ = 0;
  std::int64_t step_ = 0, dropped_ = 0;
  bool begun_ = false;
};

}  // namespace thaw
