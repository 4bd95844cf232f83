// SPDX-License-Identifier: Apache-2.0
// Limits that follow from the scene and are constant over a run.
#pragma once
#include "core/simulation/time/monitor_limits.hpp"
#include "core/simulation/time/step_limits.hpp"

namespace thaw {

struct SceneLimits {
  StepLimits fixed;               ///< from materials
  double longestContact = never;  ///< s, limit of a substep by wall contacts of solids, from materials
  double stableViscousStep = 0;   ///< largest stable dt nu / h^2 on the lattice
  double tensionInterval = 0;     ///< s, result of tensionInterval()
  MonitorLimits monitor;
};

}  // namespace thaw
