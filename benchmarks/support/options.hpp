// SPDX-License-Identifier: Apache-2.0
// Values of a benchmark's options. Throws std::invalid_argument with the expected range for an invalid value,
// so that no benchmark measures something else than its options state.
#pragma once
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <initializer_list>
#include <stdexcept>
#include <string>

namespace thaw::bench {

inline double numberOf(const std::string& key, const std::string& text, double least, double most) {
  char* end = nullptr;
  const double x = std::strtod(text.c_str(), &end);
  if (text.empty() || *end || !(x >= least && x <= most)) {
    char range[80];
    std::snprintf(range, sizeof range, "a number from %g to %g", least, most);
    throw std::invalid_argument(key + ": expected " + range + ", got '" + text + "'");
  }
  return x;
}

inline std::size_t countOf(const std::string& key, const std::string& text, std::size_t least,
                           std::size_t most) {
  char* end = nullptr;
  const unsigned long long x = std::strtoull(text.c_str(), &end, 10);
  if (text.empty() || text[0] < '0' || text[0] > '9' || *end || x < least || x > most)
    throw std::invalid_argument(key + ": expected a number from " + std::to_string(least) + " to " +
                                std::to_string(most) + ", got '" + text + "'");
  return x;
}

/// Index of `text` in `names`.
inline std::size_t oneOf(const std::string& key, const std::string& text,
                         std::initializer_list<const char*> names) {
  std::string all;
  std::size_t k = 0;
  for (const char* name : names) {
    if (text == name) return k;
    all += (k++ ? ", " : "") + std::string(name);
  }
  throw std::invalid_argument(key + ": expected one of " + all + ", got '" + text + "'");
}

}  // namespace thaw::bench
