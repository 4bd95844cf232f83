// SPDX-License-Identifier: Apache-2.0
// Errors of commands, in one form.
#pragma once
#include <fmt/format.h>

#include <cstdio>
#include <string>

namespace thaw {

/// Returns "thaw COMMAND: error: TEXT".
inline std::string commandError(const char* command, const std::string& text) {
  return fmt::format("thaw {}: error: {}", command, text);
}

/// Prints it to stderr.
inline void printCommandError(const char* command, const std::string& text) {
  fmt::print(stderr, "{}\n", commandError(command, text));
}

}  // namespace thaw
