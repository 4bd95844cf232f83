// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <vector>

#include "core/walls/walls.hpp"

namespace thaw {

/// Temporary memory of the step of carried densities.
struct CarryWork {
  std::vector<std::uint8_t> besideWall;    ///< by owned row; empty: no wall contacts
  std::vector<float> summed;               ///< CarryStep::summed
  double largestChange = 0;                ///< CarryStep::largestChange
  std::vector<WallContact> startContacts;  ///< contacts of the current row at the start of the step
};

}  // namespace thaw
