// SPDX-License-Identifier: Apache-2.0
// Cells of a grid that a triangle covers.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>

namespace thaw {

/// Corners of a triangle on a grid, in cells.
struct GridTriangle {
  std::array<float, 3> x, y;
  /// Returns twice the area, above 0 if the corners run counter-clockwise.
  float area2() const { return (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]); }
};

/// Calls use(row, first, last) for the cells of each row whose centres lie in a counter-clockwise triangle.
template<class Use> void forRowsInside(const GridTriangle& t, int columns, int rows, Use use) {
  const auto [low, high] = std::minmax_element(t.y.begin(), t.y.end());
  const float top = static_cast<float>(rows), right = static_cast<float>(columns);
  if (!(*high > 0) || !(*low < top)) return;
  const int y0 = std::max(0, static_cast<int>(std::ceil(*low - 0.5f))),
            y1 = std::min(rows - 1, static_cast<int>(std::floor(*high - 0.5f)));
  for (int row = y0; row <= y1; row++) {
    const float y = static_cast<float>(row) + 0.5f;
    float from = 0, to = right;
    for (std::size_t a = 0; a < 3; a++) {
      const std::size_t b = (a + 1) % 3;
      const float rise = t.y[b] - t.y[a];
      if (rise == 0) continue;
      const float at = t.x[a] + (t.x[b] - t.x[a]) * ((y - t.y[a]) / rise);
      // the inside is left of an edge
      if (rise > 0) to = std::min(to, at);
      else from = std::max(from, at);
    }
    const int x0 = static_cast<int>(std::ceil(from - 0.5f)),
              x1 = std::min(columns - 1, static_cast<int>(std::floor(to - 0.5f)));
    if (x0 <= x1) use(row, x0, x1);
  }
}

}  // namespace thaw
