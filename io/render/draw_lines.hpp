// SPDX-License-Identifier: Apache-2.0
// Lines over a finished picture. They are faint behind points, and neither cast nor receive shadows.
#pragma once
#include <span>
#include <vector>

#include "io/render/render_frames.hpp"

namespace thaw {

/// Depths (m along the view) of the nearest point at each pixel; infinite without one.
struct PointDepths {
  int width = 0, height = 0;
  std::vector<float> depth;
};

/// radius: m, for points without a radius of their own.
PointDepths pointDepths(const FrameView& points, const View& view, const Image& image, float radius);

struct DrawnLine {
  Vec3d from, to;  ///< m
  Rgb colour;
  float width = 1.5f;  ///< pixels
};

void drawLines(std::span<const DrawnLine> lines, const View& view, const PointDepths& depths, Image& image);

}  // namespace thaw
