// SPDX-License-Identifier: Apache-2.0
#include "io/scene/text/range.hpp"

#include <fmt/format.h>

#include <cmath>

namespace thaw {

bool holds(const Range& r, double v) {
  return std::isfinite(v) && (r.openLow ? v > r.low : v >= r.low) && (r.openHigh ? v < r.high : v <= r.high);
}

std::string rangeText(const Range& r) {
  std::string t = "any number";
  if (r.high == never && r.low > -never) t = fmt::format("{} {}", r.openLow ? ">" : ">=", r.low);
  else if (r.low == -never && r.high < never) t = fmt::format("{} {}", r.openHigh ? "<" : "<=", r.high);
  else if (r.low > -never && r.openLow && r.openHigh) t = fmt::format("> {} and < {}", r.low, r.high);
  else if (r.low > -never && r.openLow) t = fmt::format("> {} and <= {}", r.low, r.high);
  else if (r.low > -never && r.openHigh) t = fmt::format(">= {} and < {}", r.low, r.high);
  else if (r.low > -never) t = fmt::format("{} ... {}", r.low, r.high);
  return t + rangeWords(r);
}

std::string rangeWords(const Range& r) {
  return std::string(r.orNever ? " or \"never\"" : "") + (r.orOff ? " or \"off\"" : "");
}

std::string rangeRequirement(const Range& r) {
  std::string t = rangeText(r);
  const std::size_t dots = t.find(" ... ");
  return dots == std::string::npos ? t : "between " + t.replace(dots, 5, " and ");
}

}  // namespace thaw
