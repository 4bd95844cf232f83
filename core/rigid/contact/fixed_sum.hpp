// SPDX-License-Identifier: Apache-2.0
// Sums in fixed point: two integers of a shared unit. The result does not depend on the order of the terms.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>

namespace thaw {

/// A unit that is a power of two. Terms are multiples of it and at most 2^82 units, so that
/// 2^20 of them fit.
struct FixedUnit {
  double unit = 1, inverse = 1;

  /// The unit that resolves `scale` > 0 to 2^-54 and has room for terms of 2^28 scales.
  static FixedUnit forScale(double scale) {
    const int exponent = std::clamp(std::ilogb(scale) - 53, -1000, 900);
    return {std::ldexp(1.0, exponent), std::ldexp(1.0, -exponent)};
  }
};

inline constexpr double fixedLow = 1099511627776.0;  ///< 2^40, units of the upper word
inline constexpr double fixedMost = 0x1p82;          ///< units, largest term

/// Adds x, truncated to whole units, to the two words at `words`. Requires: x is finite.
inline void addFixed(std::int64_t* words, double x, const FixedUnit& unit) {
  const double units = std::clamp(x * unit.inverse, -fixedMost, fixedMost);
  const auto upper = static_cast<std::int64_t>(units * (1 / fixedLow));
  words[0] += upper;
  words[1] += static_cast<std::int64_t>(units - static_cast<double>(upper) * fixedLow);
}

/// The sum in the two words, rounded to a double.
inline double fixedValue(const std::int64_t* words, const FixedUnit& unit) {
  // carries first, so that equal sums in different words have the same bits
  const std::int64_t carry = words[1] >> 40;
  const std::int64_t low = words[1] - carry * (std::int64_t{1} << 40);
  return (static_cast<double>(words[0] + carry) * fixedLow + static_cast<double>(low)) * unit.unit;
}

}  // namespace thaw
