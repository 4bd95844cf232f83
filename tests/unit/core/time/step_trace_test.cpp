// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "core/time/phase_times.hpp"

using namespace thaw;

TEST(StepTrace, KeepsTheLastStepsInOrder) {
  StepTrace trace(3);
  const auto t = StepTrace::Clock::now();
  trace.add(TraceKind::Wait, 0, t, t);  // before the first step
  EXPECT_TRUE(trace.events().empty());
  for (int step = 0; step < 8; step++) {
    trace.beginStep(step);
    for (int k = 0; k <= step % 2; k++)
      trace.add(TraceKind::Exchange, static_cast<std::uint8_t>(k), t, t + std::chrono::nanoseconds(5), 3,
                100);
  }
  const std::vector<TraceEvent> e = trace.events();
  ASSERT_EQ(e.size(), 5u);  // steps 5, 6, 7
  EXPECT_EQ(e.front().step, 5);
  EXPECT_EQ(e.back().step, 7);
  EXPECT_EQ(e.back().name, 1);
  EXPECT_EQ(e.back().bytes, 100);
  EXPECT_EQ(e.back().messages, 3);
  EXPECT_EQ(e.back().end - e.back().begin, 5);
}

TEST(StepTrace, IsBounded) {
  StepTrace trace(2);
  const auto t = StepTrace::Clock::now();
  trace.beginStep(0);
  for (std::size_t k = 0; k < StepTrace::mostOfAStep + 10; k++) trace.add(TraceKind::Phase, 0, t, t);
  EXPECT_EQ(trace.events().size(), StepTrace::mostOfAStep);
  EXPECT_EQ(trace.dropped(), 10);
  trace.beginStep(1);
  trace.beginStep(2);
  EXPECT_EQ(trace.dropped(), 0);  // removed with their step
  EXPECT_TRUE(trace.events().empty());
}

TEST(StepTrace, RecordsTheLapsOfPhases) {
  StepTrace trace(2);
  PhaseTimes times;
  times.start();
  times.lap(StepPhase::Forces);  // without a trace
  times.trace = &trace;
  trace.beginStep(4);
  times.lap(StepPhase::Sort);
  times.lap(StepPhase::Search);
  const std::vector<TraceEvent> e = trace.events();
  ASSERT_EQ(e.size(), 2u);
  EXPECT_EQ(e[0].name, static_cast<std::uint8_t>(StepPhase::Sort));
  EXPECT_EQ(e[1].begin, e[0].end);
  EXPECT_EQ(e[1].step, 4);
}
