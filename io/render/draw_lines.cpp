// SPDX-License-Identifier: Apache-2.0
#include "io/render/draw_lines.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace thaw {
namespace {

constexpr double inFront = 0.95, behind = 0.22;  // opacities

/// End of a line in the picture. nearness: 1/m, inverse depth, which is linear along the line.
struct PictureEnd {
  float x = 0, y = 0, nearness = 0;
};

/// Returns the ends of the part of a line in front of the camera; false if there is none.
bool project(const DrawnLine& line, const View& view, std::array<PictureEnd, 2>& ends) {
  std::array<Vec3f, 2> p{single(line.from), single(line.to)};
  const float nearest = 1e-3f * std::sqrt(dot(p[0] - view.origin, p[0] - view.origin));
  float x = 0, y = 0;
  const std::array<float, 2> z{view.project(p[0], x, y), view.project(p[1], x, y)};
  for (std::size_t k = 0; k < 2; k++) {
    const float own = z[k], other = z[1 - k];
    if (own > nearest) continue;
    if (!(other > nearest)) return false;
    p[k] = p[k] + ((nearest - own) / (other - own)) * (p[1 - k] - p[k]);
  }
  for (std::size_t k = 0; k < 2; k++) ends[k].nearness = 1 / view.project(p[k], ends[k].x, ends[k].y);
  return true;
}

/// Pixels from `low` to `high` that lie in a picture of this extent.
struct Span {
  int first, last;
  Span(float low, float high, float margin, int extent)
      : first(static_cast<int>(std::clamp(std::floor(low - margin), 0.0f, static_cast<float>(extent)))),
        last(static_cast<int>(std::clamp(std::ceil(high + margin), -1.0f, static_cast<float>(extent - 1)))) {}
};

void drawLine(const DrawnLine& line, const std::array<PictureEnd, 2>& ends, const PointDepths& depths,
              Image& image) {
  const auto& [a, b] = ends;
  const float dx = b.x - a.x, dy = b.y - a.y, square = dx * dx + dy * dy, half = 0.5f * line.width;
  const Span rows(std::min(a.y, b.y), std::max(a.y, b.y), half + 1, image.height);
  for (int y = rows.first; y <= rows.last; y++) {
    // The part of the line in this row bounds the columns.
    float t0 = 0, t1 = 1;
    if (std::abs(dy) > 1e-3f) {
      const float u = (static_cast<float>(y) - half - 1 - a.y) / dy,
                  v = (static_cast<float>(y) + half + 2 - a.y) / dy;
      t0 = std::clamp(std::min(u, v), 0.0f, 1.0f), t1 = std::clamp(std::max(u, v), 0.0f, 1.0f);
    }
    const float x0 = a.x + t0 * dx, x1 = a.x + t1 * dx;
    const Span columns(std::min(x0, x1), std::max(x0, x1), half + 1, image.width);
    for (int x = columns.first; x <= columns.last; x++) {
      const float px = static_cast<float>(x) + 0.5f - a.x, py = static_cast<float>(y) + 0.5f - a.y;
      const float t = square > 0 ? std::clamp((px * dx + py * dy) / square, 0.0f, 1.0f) : 0;
      const float cover = std::clamp(half + 0.5f - std::hypot(px - t * dx, py - t * dy), 0.0f, 1.0f);
      if (cover <= 0) continue;
      const float depth = 1 / (a.nearness + t * (b.nearness - a.nearness));
      const bool hidden = depth >
                          depths.depth[static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                                       static_cast<std::size_t>(x)];
      mix(image, x, y, line.colour, static_cast<double>(cover) * (hidden ? behind : inFront));
    }
  }
}

}  // namespace

PointDepths pointDepths(const FrameView& points, const View& view, const Image& image, float radius) {
  PointDepths depths{image.width, image.height, {}};
  const auto wide = static_cast<std::size_t>(image.width), tall = static_cast<std::size_t>(image.height);
  depths.depth.assign(wide * tall, std::numeric_limits<float>::infinity());
  for (std::size_t i = 0; i < points.positions.size(); i++) {
    float x = 0, y = 0;
    const float z = view.project(points.positions[i], x, y);
    if (!(z > 0) || !std::isfinite(x + y)) continue;
    const float r = (points.radii.empty() ? radius : points.radii[i]) * view.focal / z;
    const Span rows(y, y, r, image.height), columns(x, x, r, image.width);
    for (int row = rows.first; row <= rows.last; row++)
      for (int column = columns.first; column <= columns.last; column++) {
        const float px = static_cast<float>(column) + 0.5f - x, py = static_cast<float>(row) + 0.5f - y;
        float& depth = depths.depth[static_cast<std::size_t>(row) * wide + static_cast<std::size_t>(column)];
        if (px * px + py * py <= r * r) depth = std::min(depth, z);
      }
  }
  return depths;
}

void drawLines(std::span<const DrawnLine> lines, const View& view, const PointDepths& depths, Image& image) {
  std::array<PictureEnd, 2> ends;
  for (const DrawnLine& line : lines)
    if (project(line, view, ends)) drawLine(line, ends, depths, image);
}

}  // namespace thaw
