// SPDX-License-Identifier: Apache-2.0
// Colours of meshes as bytes.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>

namespace thaw {

/// Rounds a component of a colour, 0 to 255.
inline std::uint8_t colourByte(float c) {
  return static_cast<std::uint8_t>(std::lround(std::clamp(c, 0.0f, 255.0f)));
}

}  // namespace thaw
