// SPDX-License-Identifier: Apache-2.0
// Contact angles of liquids at walls.
#pragma once
#include <cmath>

namespace thaw {

/// Cosine of a contact angle (rad); exactly 0 for 90 degrees, which needs no module.
inline double wettingOf(double angle) {
  const double wetting = std::cos(angle);
  return std::abs(wetting) < 1e-12 ? 0 : wetting;
}

}  // namespace thaw
