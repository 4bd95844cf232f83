// SPDX-License-Identifier: Apache-2.0
// Long texts of scenes, shortened for lines of output.
#pragma once
#include <string>

namespace thaw {

inline constexpr std::size_t longestTitle = 100;

/// The text, or its first `most` bytes and "..."; never half a UTF-8 character.
inline std::string shortText(const std::string& text, std::size_t most) {
  if (text.size() <= most) return text;
  std::size_t end = most;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) end--;
  return text.substr(0, end) + "...";
}

}  // namespace thaw
