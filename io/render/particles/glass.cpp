// SPDX-License-Identifier: Apache-2.0
#include "io/render/particles/glass.hpp"

#include <algorithm>
#include <cmath>

#include "io/render/light/glass_walk.hpp"

namespace thaw {

void drawGlasses(Image& image, const RenderStyle& style, const View& view, const DepthBuffer& buffer) {
  const int samples = buffer.width / image.width;
  const Encoder encode;
  for (const GlassWalk& glass : glassWalks(style))
    for (int y = 0; y < image.height; y++)
      for (int x = 0; x < image.width; x++) {
        const std::size_t sample = static_cast<std::size_t>(y * samples) * buffer.width +
                                   static_cast<std::size_t>(x) * samples;
        const Vec3f ray = view.ray(static_cast<float>((x + 0.5) * samples),
                                   static_cast<float>((y + 0.5) * samples));
        // the ray has depth 1
        const GlassLayer veil = glass.along(wide(view.origin), wide(ray), buffer.depth[sample]);
        if (veil.alpha <= 0) continue;
        const Light tint = glass.tintOf(veil.faces);
        if (!(tint == Light{1, 1, 1})) {
          const Light behind = toLinear(image.at(x, y));
          image.at(x, y) = encode({tint.x * behind.x, tint.y * behind.y, tint.z * behind.z});
        }
        const auto grey = static_cast<std::uint8_t>(
            std::lround(255 * std::min(1.0, veil.bright / veil.alpha)));
        mix(image, x, y, {grey, grey, grey}, veil.alpha);
      }
}

}  // namespace thaw
