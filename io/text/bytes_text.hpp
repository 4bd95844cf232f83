// SPDX-License-Identifier: Apache-2.0
// Amounts of memory as text.
#pragma once
#include <fmt/format.h>

#include <string>

namespace thaw {

inline std::string bytesText(double bytes) {
  if (!(bytes < 1e15)) return fmt::format("{:.1e} GB", bytes / 1e9);
  return bytes > 1e9 ? fmt::format("{:.2f} GB", bytes / 1e9) : fmt::format("{:.1f} MB", bytes / 1e6);
}

}  // namespace thaw
