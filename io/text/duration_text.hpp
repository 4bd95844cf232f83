// SPDX-License-Identifier: Apache-2.0
// Durations and counts as text.
#pragma once
#include <fmt/format.h>

#include <cmath>
#include <string>

namespace thaw {

/// Returns "0.25 s", "12 s", "5 min", "3.4 h", "12 days", "7.3 years" or "more than 1000 years".
inline std::string durationText(double s) {
  constexpr double hour = 3600, day = 24 * hour, year = 365.25 * day;
  if (!(s < 1000 * year)) return "more than 1000 years";
  if (s > 2 * year) return fmt::format("{:.1f} years", s / year);
  if (s > 3 * day) return fmt::format("{:.0f} days", s / day);
  if (s > 2 * hour) return fmt::format("{:.1f} h", s / hour);
  if (s > 120) return fmt::format("{:.0f} min", s / 60);
  return s >= 10 ? fmt::format("{:.0f} s", s) : fmt::format("{:.2g} s", s);
}

/// Returns "123456", "1.2e+12" from 1e9 on, or "infinitely many" for a count that is not finite.
inline std::string countText(double n) {
  if (!std::isfinite(n)) return "infinitely many";
  return std::abs(n) < 1e9 ? fmt::format("{:.0f}", n) : fmt::format("{:.1e}", n);
}

}  // namespace thaw
