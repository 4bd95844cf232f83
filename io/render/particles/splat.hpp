// SPDX-License-Identifier: Apache-2.0
// Depth buffer: the visible sphere at each sample of the picture.
#pragma once
#include <cstdint>
#include <vector>

#include "io/image/view.hpp"
#include "io/render/light/depth_map.hpp"

namespace thaw {

struct DepthBuffer {
  static constexpr std::uint32_t none = ~0u;
  int width = 0, height = 0;         ///< samples
  std::vector<float> depth;          ///< m along the view; infinite for background
  std::vector<std::uint32_t> index;  ///< sphere, or none
};

/// Draws all spheres as seen in `view`, whose pixels are the samples. The first of equally near ones wins;
/// nothing nearer than `near` is drawn.
DepthBuffer splatSpheres(const Discs& spheres, const View& view, int width, int height, float near);

}  // namespace thaw
