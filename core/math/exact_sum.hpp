// Sums of doubles without rounding, in integers: the result does not depend on the order of the terms, nor on
// how they were spread over ranks (a Kulisch accumulator in 32-bit digits; Neal 2015, "Fast exact summation
// using small and large superaccumulators").
#pragma once
#include <array>
#include <cstdint>
#include <span>

namespace thaw {

/// To add sums of many ranks: carry() each, add the digit arrays element by element (any order, up to 2^29
/// ranks), put them into one ExactSum and ask for its value(). The same terms give the same bits, however
/// they were spread.
struct ExactSum {
  static constexpr int digits = 70;          ///< 32 bits each, from 2^-1088 up: every finite double fits
  std::array<std::int64_t, digits> digit{};  ///< signed; digits of several sums may be added element by
                                             ///< element
  std::int32_t pending = 0;                  ///< adds since the last carry

  void add(double x);    ///< x finite (a non-finite x makes value() NaN)
  void carry();          ///< brings every digit but the last into [0, 2^32)
  double value() const;  ///< the sum, rounded once to nearest, ties to even; infinite where that overflows
  ExactSum& operator+=(const ExactSum& other);
  /// Adds factor times another sum, exactly (but for bits below 2^-1088): linear, so that sums of many ranks
  /// can be multiplied before they are added up.
  void addProduct(const ExactSum& other, double factor);
};

}  // namespace thaw
