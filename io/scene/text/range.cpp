// SPDX-License-Identifier: Apache-2.0
#include "io/scene/text/range.hpp"

#include <fmt/format.h>

#include <cmath>

namespace thaw {

bool Range::holds(double v) const {
  return std::isfinite(v) && (openLow ? v > low : v >= low) && (openHigh ? v < high : v <= high);
}

std::string Range::text() const {
  constexpr double never = std::numeric_limits<double>::infinity();
  std::string t = "any number";
  if (high == never && low > -never) t = fmt::format("{} {}", openLow ? ">" : ">=", low);
  else if (low == -never && high < never) t = fmt::format("{} {}", openHigh ? "<" : "<=", high);
  else if (low > -never && openLow && openHigh) t = fmt::format("> {} and < {}", low, high);
  else if (low > -never && openLow) t = fmt::format("> {} and <= {}", low, high);
  else if (low > -never && openHigh) t = fmt::format(">= {} and < {}", low, high);
  else if (low > -never) t = fmt::format("{} ... {}", low, high);
  return t + words();
}

std::string Range::words() const {
  return std::string(orNever ? " or \"never\"" : "") + (orOff ? " or \"off\"" : "");
}

std::string Range::requirement() const {
  std::string t = text();
  const std::size_t dots = t.find(" ... ");
  return dots == std::string::npos ? t : "between " + t.replace(dots, 5, " and ");
}

}  // namespace thaw
