// SPDX-License-Identifier: Apache-2.0
#include "core/math/exact_sum.hpp"

#include <bit>
#include <cmath>
#include <limits>

namespace thaw {

namespace {

constexpr int lowest = -1088;                              // exponent of digit 0
constexpr std::int64_t notFinite = std::int64_t(1) << 40;  // value of the last digit that marks a non-finite
                                                           // sum; the last digit of finite sums is small
constexpr std::int64_t digitMask = 0xffffffff;

}  // namespace

void ExactSum::add(double x) {
  const std::uint64_t bits = std::bit_cast<std::uint64_t>(x);
  const int exponent = static_cast<int>(bits >> 52 & 0x7ff);
  if (exponent == 0x7ff) {
    if (digit[digits - 1] < notFinite * 1024) digit[digits - 1] += notFinite;
    return;
  }
  // x = mantissa * 2^(place + lowest)
  const std::uint64_t fraction = bits & 0xfffffffffffffull,
                      mantissa = exponent > 0 ? fraction | 0x10000000000000ull : fraction;
  const int place = (exponent > 0 ? exponent : 1) - 1075 - lowest;
  const auto at = static_cast<std::size_t>(place / 32);
  const unsigned __int128 shifted = static_cast<unsigned __int128>(mantissa) << (place % 32);
  const std::int64_t sign = bits >> 63 ? -1 : 1;
  for (std::size_t k = 0; k < 3; k++)
    digit[at + k] += sign * (static_cast<std::int64_t>(shifted >> (32 * k)) & digitMask);
  if (++pending >= (1 << 30)) carry();
}

void ExactSum::carry() {
  for (std::size_t k = 0; k + 1 < digits; k++) {
    digit[k + 1] += digit[k] >> 32;  // rounds down, so the remainder is not negative
    digit[k] &= digitMask;
  }
  pending = 0;
}

double ExactSum::value() const {
  ExactSum s = *this;
  s.carry();
  if (s.digit[digits - 1] >= notFinite / 2) return std::numeric_limits<double>::quiet_NaN();
  const bool negative = s.digit[digits - 1] < 0;
  if (negative) {
    for (std::int64_t& d : s.digit) d = -d;
    s.carry();
  }
  int top = digits - 1;
  while (top >= 0 && s.digit[static_cast<std::size_t>(top)] == 0) top--;
  if (top < 0) return 0;
  // Three digits have more than 64 bits. Lower digits only decide ties.
  unsigned __int128 head = 0;
  for (int k = top; k > top - 3; k--)
    head = head << 32 | static_cast<unsigned __int128>(k >= 0 ? s.digit[static_cast<std::size_t>(k)] : 0);
  for (int k = 0; k <= top - 3; k++)
    if (s.digit[static_cast<std::size_t>(k)] != 0) head |= 1;
  const double rounded = std::ldexp(static_cast<double>(head), 32 * (top - 2) + lowest);
  return negative ? -rounded : rounded;
}

ExactSum& ExactSum::operator+=(const ExactSum& other) {
  ExactSum o = other;
  o.carry();
  for (std::size_t k = 0; k < digits; k++) digit[k] += o.digit[k];
  // A non-finite sum stays non-finite and never overflows.
  if (digit[digits - 1] > notFinite * 1024) digit[digits - 1] = notFinite;
  if (++pending >= (1 << 30)) carry();
  return *this;
}

void ExactSum::addProduct(const ExactSum& other, double factor) {
  ExactSum o = other;
  o.carry();
  const std::uint64_t bits = std::bit_cast<std::uint64_t>(factor);
  const int exponent = static_cast<int>(bits >> 52 & 0x7ff);
  if (exponent == 0x7ff || o.digit[digits - 1] >= notFinite / 2)
    return add(std::numeric_limits<double>::quiet_NaN());
  const std::uint64_t fraction = bits & 0xfffffffffffffull,
                      mantissa = exponent > 0 ? fraction | 0x10000000000000ull : fraction;
  if (mantissa == 0) return;
  const int shift = (exponent > 0 ? exponent : 1) - 1075;
  std::int64_t sign = bits >> 63 ? -1 : 1;
  if (o.digit[digits - 1] < 0) {
    for (std::int64_t& d : o.digit) d = -d;
    o.carry();
    sign = -sign;
  }
  for (int k = 0; k < digits; k++) {
    const std::int64_t d = o.digit[static_cast<std::size_t>(k)];
    if (d == 0) continue;
    unsigned __int128 product = static_cast<unsigned __int128>(d) * mantissa;
    int place = 32 * k + shift;
    if (place < 0) {
      product = place > -128 ? product >> -place : 0;
      place = 0;
    }
    const auto at = static_cast<std::size_t>(place / 32);
    // The product has up to 85 bits, 117 after the shift: four digits.
    if (at + 4 >= digits) return add(std::numeric_limits<double>::quiet_NaN());
    product <<= place % 32;
    for (std::size_t j = 0; j < 4; j++)
      digit[at + j] += sign * (static_cast<std::int64_t>(product >> (32 * j)) & digitMask);
  }
  pending += 5;  // at most five of these products overlap in a digit
  if (pending >= (1 << 30)) carry();
}

}  // namespace thaw
