// What a rank did in its last steps: slices of phases, of waiting, and of exchanges under way, for `thaw run
// --profile`. Of bounded size: the events of the last steps, and at most so many of each. No result depends
// on it.
#pragma once
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace thaw {

/// Step: a whole step. Phase: a lap of PhaseTimes. Wait: the rank can do nothing but wait for others.
/// Exchange: messages are on their way, while the rank may do something else.
enum class TraceKind : std::uint8_t { Step, Phase, Wait, Exchange };

struct TraceEvent {
  std::int64_t begin = 0, end = 0;  ///< ns of this process's steady clock
  std::int64_t step = 0;
  std::int64_t bytes = 0;     ///< sent, of an exchange
  std::int32_t messages = 0;  ///< sent, of an exchange
  TraceKind kind = TraceKind::Step;
  std::uint8_t name = 0;  ///< a StepPhase, or a MessagesFor of messages (parallel/traffic.hpp)
};

class StepTrace {
 public:
  using Clock = std::chrono::steady_clock;
  static constexpr std::size_t mostOfAStep = 1 << 14;

  /// Keeps the last `steps` steps (at least 1).
  explicit StepTrace(std::size_t steps) : ring_(steps > 0 ? steps : 1) {}

  /// What follows belongs to this step; the oldest one is forgotten.
  void beginStep(std::int64_t step) {
    step_ = step;
    begun_ = true;
    at_ = (at_ + 1) % ring_.size();
    dropped_ -= ring_[at_].dropped;
    ring_[at_].dropped = 0;
    ring_[at_].events.clear();
  }

  /// Nothing is kept before the first step.
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

  /// Of the steps that are kept, oldest first; within a step in the order in which they ended.
  std::vector<TraceEvent> events() const {
    std::vector<TraceEvent> all;
    for (std::size_t k = 1; k <= ring_.size(); k++) {
      const std::vector<TraceEvent>& one = ring_[(at_ + k) % ring_.size()].events;
      all.insert(all.end(), one.begin(), one.end());
    }
    return all;
  }
  /// Events of the kept steps that found no room.
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
