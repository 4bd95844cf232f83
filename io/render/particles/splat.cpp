// SPDX-License-Identifier: Apache-2.0
#include "io/render/particles/splat.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace thaw {

DepthBuffer splatSpheres(const Discs& spheres, const View& view, int width, int height, float near) {
  DepthBuffer buffer;
  buffer.width = width;
  buffer.height = height;
  buffer.depth.assign(static_cast<std::size_t>(width) * height, std::numeric_limits<float>::infinity());
  buffer.index.assign(buffer.depth.size(), DepthBuffer::none);
  const float w = static_cast<float>(width), h = static_cast<float>(height);
  for (std::size_t i = 0; i < spheres.positions.size(); i++) {
    const float radius = spheres.radius(i);
    float x, y;
    const float z = view.project(spheres.positions[i], x, y);
    if (!(z > near + radius)) continue;
    // Radius in samples, large enough to cover at least one sample centre.
    const float r = std::max(view.focal * radius / z, 0.75f);
    if (!(x > -r && y > -r && x < w + r && y < h + r)) continue;
    const float over = 1 / (r * r);
    const int y0 = static_cast<int>(std::max(0.0f, std::ceil(y - r - 0.5f))),
              y1 = static_cast<int>(std::min(h - 1, std::floor(y + r - 0.5f)));
    for (int py = y0; py <= y1; py++) {
      const float dy = static_cast<float>(py) + 0.5f - y, rest = r * r - dy * dy,
                  half = std::sqrt(std::max(0.0f, rest));
      const int x0 = static_cast<int>(std::max(0.0f, std::ceil(x - half - 0.5f))),
                x1 = static_cast<int>(std::min(w - 1, std::floor(x + half - 0.5f)));
      const std::size_t row = static_cast<std::size_t>(py) * width;
      for (int px = x0; px <= x1; px++) {
        const float dx = static_cast<float>(px) + 0.5f - x;
        const float depth = z - radius * std::sqrt(std::max(0.0f, (rest - dx * dx) * over));
        if (depth < buffer.depth[row + px]) {
          buffer.depth[row + px] = depth;
          buffer.index[row + px] = static_cast<std::uint32_t>(i);
        }
      }
    }
  }
  return buffer;
}

}  // namespace thaw
