// SPDX-License-Identifier: Apache-2.0
// Exact sums of doubles, in integer arithmetic. The result is independent of the order of the terms and of
// their distribution over ranks. Kulisch accumulator in 32-bit digits (N15).
#pragma once
#include <array>
#include <cstdint>
#include <span>

namespace thaw {

/// To add the sums of up to 2^29 ranks, call carry() on each and add the digit arrays element by element, in
/// any order. Then copy the digits into one ExactSum and take its value(). Equal terms give equal bits for
/// any distribution.
struct ExactSum {
  static constexpr int digits = 70;          ///< 32 bits each, starting at 2^-1088; every finite double fits
  std::array<std::int64_t, digits> digit{};  ///< signed; digits of several sums may be added element by
                                             ///< element
  std::int32_t pending = 0;                  ///< adds since the last carry

  void add(double x);    ///< if x is not finite, value() is NaN
  void carry();          ///< brings every digit except the last into [0, 2^32)
  double value() const;  ///< the sum, rounded once to nearest, ties to even; infinite on overflow
  ExactSum& operator+=(const ExactSum& other);
  /// Adds factor times another sum, exactly except for bits below 2^-1088. The operation is linear, so the
  /// sums of ranks may be multiplied before they are added.
  void addProduct(const ExactSum& other, double factor);
};

}  // namespace thaw
