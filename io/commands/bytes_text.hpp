// Amounts of memory as people read them.
#pragma once
#include <fmt/format.h>

#include <string>

namespace thaw {

inline std::string bytesText(double bytes) { return bytes > 1e9 ? fmt::format("{:.2f} GB", bytes / 1e9) : fmt::format("{:.1f} MB", bytes / 1e6); }

}  // namespace thaw
