// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <thread>

#include "core/time/phase_times.hpp"

using namespace thaw;

TEST(PhaseTimes, AnInnerTimerStopsTheOuterOne) {
  PhaseTimes t;
  const auto start = PhaseTimes::Clock::now();
  {
    const PhaseTimer outer(t, StepPhase::Forces);
    {
      const PhaseTimer inner(t, StepPhase::Exchange);
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  const double wall = std::chrono::duration<double>(PhaseTimes::Clock::now() - start).count();
  EXPECT_GE(t[StepPhase::Exchange], 0.02);
  EXPECT_GE(t[StepPhase::Forces], 0.005);
  EXPECT_LE(t[StepPhase::Forces] + t[StepPhase::Exchange], wall);  // no time counts twice
  EXPECT_DOUBLE_EQ(t.total(), t[StepPhase::Forces] + t[StepPhase::Exchange]);
  EXPECT_EQ(t.current, StepPhase::None);
}

TEST(PhaseTimes, EveryPhaseHasAName) {
  for (std::size_t k = 0; k <= stepPhases; k++) EXPECT_NE(phaseName(static_cast<StepPhase>(k)), nullptr);
  EXPECT_STREQ(phaseName(StepPhase::Other), "other");
  EXPECT_STREQ(phaseName(StepPhase::Migrate), "migrate");
}
