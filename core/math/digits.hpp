// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdio>
#include <string>

namespace thaw {

/// Returns a number with three significant digits, for messages: "0.006", "1e-07".
inline std::string inDigits(double value) {
  char digits[32];
  std::snprintf(digits, sizeof digits, "%.3g", value);
  return digits;
}

}  // namespace thaw
