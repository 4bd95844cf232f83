// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>

namespace thaw {

/// Returns the text as one word of a shell command.
inline std::string shellWord(std::string text) {
  for (std::size_t at = 0; (at = text.find('\'', at)) != std::string::npos; at += 4)
    text.replace(at, 1, "'\\''");
  return "'" + text + "'";
}

}  // namespace thaw
