// The particle that an alarm is about: the fastest, the densest, ... of all ranks, and of equals the one with
// the lowest id.
#pragma once
#include "core/watch/watch.hpp"

namespace thaw {

struct Suspect {
  bool here = false;    ///< this rank owns it
  std::size_t row = 0;  ///< there
  double value = 0;     ///< what the alarm is about: m/s, filling, det F, J/kg; of all ranks
};

/// Collective; the same particle on any number of ranks. Nobody's where there is no particle at all.
Suspect findSuspect(const World& world, Alarm alarm, Limit limitedBy, Reducer& all);

}  // namespace thaw
