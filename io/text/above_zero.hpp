// SPDX-License-Identifier: Apache-2.0
// The check of options for numbers above zero. The check of CLI11 prints a range of 309 digits.
#pragma once
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <string>

namespace thaw {

inline CLI::Validator aboveZero() {
  return CLI::Validator(
      [](std::string& text) {
        double number = 0;
        return CLI::detail::lexical_cast(text, number) && number > 0
                   ? std::string()
                   : fmt::format("expected a number above 0, not '{}'", text);
      },
      "POSITIVE", "above zero");
}

}  // namespace thaw
