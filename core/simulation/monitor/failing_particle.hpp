// SPDX-License-Identifier: Apache-2.0
// The particle that caused a failure: the fastest, the densest, ... of all ranks. Among equal values, the
// particle with the lowest id is chosen.
#pragma once
#include "core/simulation/monitor/monitor.hpp"

namespace thaw {

struct FailingParticle {
  bool here = false;    ///< true: this rank owns the particle
  std::size_t row = 0;  ///< its row on that rank
  double value = 0;     ///< largest value over all ranks, which caused the failure: m/s, relative density,
                        ///< det F, or J/kg
};

/// Returns the particle, the same on any number of ranks. Without particles, `here` is false on all ranks.
/// Collective.
FailingParticle findFailingParticle(const World& world, Failure failure, Limit limitedBy, Reducer& all);

}  // namespace thaw
