// Simulated time. Frame times and the end are hit exactly: steps before one are made equal so that they end
// there, and the time is set to it.
#pragma once
#include <cstdint>

namespace thaw {

struct Clock {
  double time = 0;             ///< s
  double end = 0;              ///< s
  double every = 0;            ///< s between frames
  std::int64_t step = 0;       ///< steps done
  std::int64_t frame = 0;      ///< frames written; the next is due at frame * every
  double dt = 0;               ///< s, wanted of the next step; it is at most that long (nextStep)
  double stepDt = 0;           ///< s, of the last step
  int substeps = 1;            ///< of the solids in the next step (core/solid_substeps.hpp)
  const char* limitedBy = "";  ///< which limit set dt
};

}  // namespace thaw
