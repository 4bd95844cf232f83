// SPDX-License-Identifier: Apache-2.0
#include "io/render/surfels/splat_faces.hpp"

#include <algorithm>
#include <cmath>

namespace thaw {
namespace {

constexpr float rounding = 1e-3f;  // tolerance in barycentric coordinates: no gap at a common edge

/// Interpolates the corners' shades. A smoothed normal at a fold that faces away from the camera is turned to
/// its horizon.
SurfelShade mixed(const CameraFaces::Face& f, std::span<const SurfelShade> shades,
                  const std::array<float, 3>& share, const Vec3f& ray) {
  SurfelShade s{{}, {}, {}, 0};
  for (std::size_t k = 0; k < 3; k++) {
    const SurfelShade& c = shades[f.shade[k]];
    s.normal += share[k] * c.normal;
    s.fromSky += share[k] * c.fromSky;
    s.ofSun += share[k] * c.ofSun;
    s.sun += share[k] * c.sun;
  }
  const float away = dot(s.normal, ray);
  if (away > 0) s.normal += ray * (-away / dot(ray, ray));
  const float l = std::sqrt(dot(s.normal, s.normal));
  s.normal = l > 0 ? s.normal / l : shades[f.shade[0]].normal;
  return s;
}

}  // namespace

CameraFaces facesBefore(std::span<const Vec3f> positions, std::span<const std::array<std::uint32_t, 3>> faces,
                        const SampleGrid& samples, float near) {
  const View& view = samples.view;
  const int width = samples.width, height = samples.height;
  CameraFaces all;
  for (const auto& rows : faces) {
    CameraFaces::Face f{{}, {}, rows, width, -1, height, -1};
    bool before = true;
    float left = static_cast<float>(width), right = 0, top = static_cast<float>(height), bottom = 0;
    for (std::size_t k = 0; k < 3; k++) {
      const Vec3f d = positions[rows[k]] - view.origin;
      Vec3f& c = f.corner[k];
      c = {dot(d, view.right), dot(d, view.up), dot(d, view.forward)};
      before = before && c.z > near && c.z > 0;
      if (!before) break;
      const float x = view.centreX + view.focal * c.x / c.z, y = view.centreY - view.focal * c.y / c.z;
      left = std::min(left, x), right = std::max(right, x), top = std::min(top, y),
      bottom = std::max(bottom, y);
    }
    if (!before ||
        !(right > 0 && bottom > 0 && left < static_cast<float>(width) && top < static_cast<float>(height)))
      continue;
    f.normal = cross(f.corner[1] - f.corner[0], f.corner[2] - f.corner[0]);
    if (!(dot(f.normal, f.corner[0]) > 0)) continue;  // right, up, forward are a left-handed system
    f.x0 = static_cast<int>(std::max(0.0f, left)),
    f.x1 = static_cast<int>(std::min(static_cast<float>(width - 1), right));
    f.y0 = static_cast<int>(std::max(0.0f, top)),
    f.y1 = static_cast<int>(std::min(static_cast<float>(height - 1), bottom));
    all.faces.push_back(f);
  }
  return all;
}

void drawFaces(const CameraFaces& all, std::span<const std::uint32_t> which,
               std::span<const SurfelShade> shades, const View& view, SurfelTile& tile,
               std::vector<std::uint8_t>& drawn) {
  const float over = 1 / view.focal;
  for (const std::uint32_t k : which) {
    const CameraFaces::Face& f = all.faces[k];
    const float plane = dot(f.normal, f.corner[0]), area2 = dot(f.normal, f.normal);
    if (!(area2 > 0)) continue;
    const Vec3f e1 = f.corner[1] - f.corner[0], e2 = f.corner[2] - f.corner[0];
    for (int y = std::max(f.y0, tile.y); y <= std::min(f.y1, tile.y + tile.height - 1); y++)
      for (int x = std::max(f.x0, tile.x); x <= std::min(f.x1, tile.x + tile.width - 1); x++) {
        const float rx = (static_cast<float>(x) + 0.5f - view.centreX) * over,
                    ry = (view.centreY - static_cast<float>(y) - 0.5f) * over;
        const float t = plane / (f.normal.x * rx + f.normal.y * ry + f.normal.z);
        const std::size_t s = static_cast<std::size_t>(y - tile.y) * tile.width + (x - tile.x);
        if (!(t > 0 && t < tile.depth[s])) continue;
        const Vec3f p{t * rx - f.corner[0].x, t * ry - f.corner[0].y, t - f.corner[0].z};
        const float b = dot(cross(p, e2), f.normal) / area2, c = dot(cross(e1, p), f.normal) / area2,
                    a = 1 - b - c;
        if (!(a >= -rounding && b >= -rounding && c >= -rounding)) continue;
        tile.depth[s] = t;
        drawn[s] = 1;
        tile.shade[s] = mixed(f, shades, {a, b, c}, rx * view.right + ry * view.up + view.forward);
      }
  }
}

}  // namespace thaw
