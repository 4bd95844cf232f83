// SPDX-License-Identifier: Apache-2.0
// Checks of options for numbers. CLI11 accepts "nan" and "inf", also within a range, and prints a range of
// 309 digits for numbers above zero.
#pragma once
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <string>

namespace thaw {

/// Returns a check for numbers that `accepts` returns true for, described in words. kind: for the help.
template<class Accepts>
CLI::Validator numberOption(const std::string& words, const std::string& kind, Accepts accepts) {
  return CLI::Validator(
      [words, accepts](std::string& text) {
        double number = 0;
        return CLI::detail::lexical_cast(text, number) && accepts(number)
                   ? std::string()
                   : fmt::format("expected {}, not '{}'", words, text);
      },
      kind, words);
}

inline CLI::Validator aboveZero() {
  return numberOption("a number above 0", "POSITIVE", [](double x) { return x > 0; });
}

inline CLI::Validator finiteNumber() {
  return numberOption("a finite number", "", [](double x) { return std::isfinite(x); });
}

}  // namespace thaw
