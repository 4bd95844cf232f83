// SPDX-License-Identifier: Apache-2.0
// Counts with their noun.
#pragma once
#include <fmt/format.h>

#include <cstdint>
#include <string>

namespace thaw {

/// Returns "1 particle" or "2 particles"; the plural adds an s.
inline std::string counted(std::int64_t n, const char* noun) {
  return fmt::format("{} {}{}", n, noun, n == 1 ? "" : "s");
}

}  // namespace thaw
