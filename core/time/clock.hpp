// SPDX-License-Identifier: Apache-2.0
// Simulated time. Frame times and the end are hit exactly. Equal steps lead up to each of them, and the time
// is then set to the exact value.
#pragma once
#include <cstdint>

namespace thaw {

struct Clock {
  double time = 0;             ///< s
  double end = 0;              ///< s
  double every = 0;            ///< s between frames
  std::int64_t step = 0;       ///< steps done
  std::int64_t frame = 0;      ///< frames written; the next is due at frame * every
  double dt = 0;               ///< s, target length of the next step; an upper bound (nextStep)
  double stepDt = 0;           ///< s, length of the last step
  int substeps = 1;            ///< number of substeps of solids in the next step
                               ///< (core/simulation/solid_substeps.hpp)
  const char* limitedBy = "";  ///< name of the limit that set dt
};

}  // namespace thaw
