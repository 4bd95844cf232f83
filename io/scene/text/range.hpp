// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <limits>
#include <string>

namespace thaw {

/// Range of a key. NaN is never in it. Infinity is only allowed as the word "never".
struct Range {
  double low = -std::numeric_limits<double>::infinity(), high = std::numeric_limits<double>::infinity();
  bool openLow = false, openHigh = false;  ///< the end is excluded
  bool orNever = false;                    ///< the word "never" is allowed
  bool orOff = false;                      ///< the word "off" is allowed, and means 0
  bool holds(double value) const;
  std::string text() const;         ///< "> 0", "0 ... 1", "any number"
  std::string requirement() const;  ///< "> 0", "between 0 and 1", "any number"
  std::string words() const;        ///< ` or "never"`: the words that are allowed beside numbers, or ""
};
inline Range anyNumber() { return {}; }
inline Range positive() { return {0, std::numeric_limits<double>::infinity(), true, false, false}; }
inline Range notNegative() { return {0, std::numeric_limits<double>::infinity(), false, false, false}; }
inline Range atLeast(double low) {
  return {low, std::numeric_limits<double>::infinity(), false, false, false};
}
inline Range between(double low, double high) { return {low, high, false, false, false}; }
inline Range inside(double low, double high) { return {low, high, true, true, false}; }
inline Range orNever(Range r) { return r.orNever = true, r; }
inline Range orOff(Range r) { return r.orOff = true, r; }

}  // namespace thaw
