// SPDX-License-Identifier: Apache-2.0
// Checks of `--out` of exports.
#pragma once
#include <filesystem>
#include <stdexcept>
#include <string>

namespace thaw {

inline bool isFolder(const std::filesystem::path& path) {
  std::error_code error;
  return std::filesystem::is_directory(path, error);
}

/// endings: the file endings that the format allows, in words.
[[noreturn]] inline void refuseOut(const std::filesystem::path& out, const std::string& endings) {
  throw std::invalid_argument("--out: expected a folder or a file that ends in " + endings + ", got " +
                              out.string());
}

}  // namespace thaw
