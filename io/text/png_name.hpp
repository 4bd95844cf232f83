// SPDX-License-Identifier: Apache-2.0
// The check of options for names of pictures, which are PNG files.
#pragma once
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>

namespace thaw {

/// Accepts names that end in .png, and names without an ending.
inline CLI::Validator pngName() {
  return CLI::Validator(
      [](std::string& text) {
        const std::string ending = CLI::detail::to_lower(std::filesystem::path(text).extension().string());
        return ending.empty() || ending == ".png"
                   ? std::string()
                   : fmt::format("pictures are PNG files: expected a name that ends in .png, not '{}'", text);
      },
      "", "PNG name");
}

}  // namespace thaw
