// SPDX-License-Identifier: Apache-2.0
// The particle behind a failure: the fastest, the densest, ... of all ranks, and of equals the one with the
// lowest id.
#pragma once
#include "core/simulation/monitor/monitor.hpp"

namespace thaw {

struct FailingParticle {
  bool here = false;    ///< this rank owns it
  std::size_t row = 0;  ///< its row on that rank
  double value = 0;     ///< value that caused the failure: m/s, relative density, det F, J/kg; over all ranks
};

/// Collective; the same particle on any number of ranks. No rank has it if there are no particles.
FailingParticle findFailingParticle(const World& world, Failure failure, Limit limitedBy, Reducer& all);

}  // namespace thaw
