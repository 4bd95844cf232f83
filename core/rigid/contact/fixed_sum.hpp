// SPDX-License-Identifier: Apache-2.0
// Sums of multiples of a shared unit. The result does not depend on the order of the terms.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "core/halo/halo.hpp"

namespace thaw {

/// Unit of sums, a power of two. Terms are rounded to multiples of it, and clamped to 2^82 units.
struct FixedUnit {
  double unit = 1;

  /// Returns the unit that resolves `scale` > 0 to 2^-bits. With 54 bits, terms may be as large as 2^28
  /// scales.
  static FixedUnit forScale(double scale, int bits = 54) {
    return {std::ldexp(1.0, std::clamp(std::ilogb(scale) + 1 - bits, -1000, 900))};
  }
};

inline constexpr double fixedMost = 0x1p82;  ///< units, largest term
inline constexpr int fixedLowBits = 34;      ///< number of bits of the lower part
inline constexpr double fixedHigh = 0x1p34;  ///< unit of the upper part, in units of the sum

/// N sums, each in two parts. Each part is an integer multiple of its unit, below 2^53 units. Additions of
/// doubles are therefore exact, for up to 2^20 terms and sums of up to 2^86 units.
template<std::size_t N> struct FixedSums {
  double high[N] = {}, low[N] = {};

  /// Adds a term to each sum. units: units of the sums. Requires: terms are finite.
  void add(const double (&terms)[N], const double (&units)[N]) {
    // Addition of 1.5 * 2^52 units rounds to whole units.
    constexpr double rounder = 0x1.8p52;
    for (std::size_t k = 0; k < N; k++) {
      const double most = fixedMost * units[k], x = std::min(std::max(terms[k], -most), most);
      const double toHigh = rounder * fixedHigh * units[k], toLow = rounder * units[k];
      const double upper = (x + toHigh) - toHigh;
      high[k] += upper;
      low[k] += ((x - upper) + toLow) - toLow;
    }
  }

  /// Writes sum k as two integers, for addition over ranks.
  void store(std::size_t k, double unit, std::int64_t* words) const {
    const double inverse = 1 / unit;
    words[0] = static_cast<std::int64_t>(high[k] * inverse * (1 / fixedHigh));
    words[1] = static_cast<std::int64_t>(low[k] * inverse);
  }
};

/// Returns the sum in two words, rounded to a double.
inline double fixedValue(const std::int64_t* words, double unit) {
  // the carry is applied first, so equal sums in different words give the same bits
  const std::int64_t carry = words[1] >> fixedLowBits;
  const std::int64_t low = words[1] - carry * (std::int64_t{1} << fixedLowBits);
  return (static_cast<double>(words[0] + carry) * fixedHigh + static_cast<double>(low)) * unit;
}

/// Sums of N numbers over contacts and ranks, rounded to a shared unit.
template<std::size_t N> struct ContactSums {
  double units[N];
  FixedSums<N> here{};
  std::array<std::int64_t, 2 * N> words{};

  explicit ContactSums(FixedUnit unit) { std::fill_n(units, N, unit.unit); }
  void add(const double (&terms)[N]) { here.add(terms, units); }
  void sum(Reducer& all) {
    for (std::size_t k = 0; k < N; k++) here.store(k, units[k], &words[2 * k]);
    all.sum(words);
  }
  double value(std::size_t k) const { return fixedValue(&words[2 * k], units[k]); }
};

}  // namespace thaw
