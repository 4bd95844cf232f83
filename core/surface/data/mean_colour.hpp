// SPDX-License-Identifier: Apache-2.0
// Means of surfels' colours.
#pragma once
#include <cmath>
#include <cstdint>

namespace thaw {

/// Weighted mean of colours, in integers, so it does not depend on the order.
struct MeanColour {
  std::int64_t weight = 0, part[3]{};
  /// Adds a colour with u from 0 at the end of the range to 1.
  void add(double u, std::uint32_t colour) {
    const std::int64_t w = std::llround(65536 * u * u * u);
    weight += w;
    for (int c = 0; c < 3; c++) part[c] += w * static_cast<std::int64_t>(colour >> 8 * c & 255);
  }
  std::uint32_t colour() const {
    std::uint32_t packed = 0;
    for (int c = 0; c < 3; c++)
      packed |= static_cast<std::uint32_t>((part[c] + weight / 2) / weight) << 8 * c;
    return packed;
  }
};

}  // namespace thaw
