// SPDX-License-Identifier: Apache-2.0
// Bars of progress as text.
#pragma once
#include <algorithm>
#include <string>

namespace thaw {

/// Returns "[=====>    ]" of `columns` characters, at least 4. Below a share of 1 it has a ">".
inline std::string progressBar(double share, int columns) {
  const int width = std::max(2, columns - 2),
            done = static_cast<int>(std::clamp(share, 0.0, 1.0) * static_cast<double>(width));
  std::string bar = std::string(static_cast<std::size_t>(done), '=') + (done < width ? ">" : "");
  bar.resize(static_cast<std::size_t>(width), ' ');
  return "[" + bar + "]";
}

}  // namespace thaw
