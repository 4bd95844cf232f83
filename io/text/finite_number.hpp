// SPDX-License-Identifier: Apache-2.0
// The check of options for finite numbers. CLI11 accepts "nan" and "inf", also within a range.
#pragma once
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <string>

namespace thaw {

inline CLI::Validator finiteNumber() {
  return CLI::Validator(
      [](std::string& text) {
        double number = 0;
        return CLI::detail::lexical_cast(text, number) && std::isfinite(number)
                   ? std::string()
                   : fmt::format("expected a finite number, not '{}'", text);
      },
      "", "finite");
}

}  // namespace thaw
