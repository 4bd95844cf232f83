// SPDX-License-Identifier: Apache-2.0
#include "io/surface_mesh/plane_field.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace thaw {

PlaneField::PlaneField(const SurfaceFrame& frame, double margin) : frame_(frame), margin_(margin) {
  for (const float radius : frame.radii) farthest_ = std::max(farthest_, planeReach * radius + margin);
  fillBins(frame.positions.data(), frame.positions.size(), farthest_, bins_);
}

bool PlaneField::onDisc(const Vec3d& x, const Vec3f& normal) const {
  bool on = false;
  forRowsWithin(bins_, x, farthest_, [&](std::uint32_t i, double) {
    const Vec3f& m = frame_.normals[i];
    const Vec3d away = x - frame_.positions[i];
    const double r = frame_.radii[i], along = dot(away, Vec3d{m.x, m.y, m.z}),
                 beside2 = dot(away, away) - along * along;
    on = on || (dot(m, normal) > 0.5f && std::abs(along) < 0.3 * r && beside2 < r * r);
  });
  return on;
}

PlaneHeight PlaneField::at(const Vec3d& x) const {
  thread_local std::vector<std::pair<std::uint32_t, double>> near;  // rows, and squares of distances
  near.clear();
  double nearest2 = std::numeric_limits<double>::infinity();
  std::uint32_t nearest = 0;
  forRowsWithin(bins_, x, farthest_, [&](std::uint32_t i, double d2) {
    const double reach = planeReach * frame_.radii[i] + margin_;
    if (!(d2 < reach * reach)) return;
    near.emplace_back(i, d2);
    if (d2 < nearest2) nearest2 = d2, nearest = i;
  });
  PlaneHeight h;
  if (!(nearest2 < std::numeric_limits<double>::infinity())) return h;
  double weight = 0, value = 0;
  Vec3d offset{}, normal{}, colour{};
  for (const auto& [i, d2] : near) {
    const Vec3f& m = frame_.normals[i];
    if (dot(m, frame_.normals[nearest]) < planeAgreement) continue;
    // relative to the nearest one, so weights do not vanish far from the surface
    const double width = planeSharpness * frame_.radii[i];
    const double w = std::exp(std::max(-60.0, (nearest2 - d2) * 0.5 / (width * width)));
    const Vec3d n{m.x, m.y, m.z}, away = x - frame_.positions[i];
    const Rgb& c = frame_.colours[i];
    weight += w;
    value += w * dot(away, n);
    offset += w * away;
    normal += w * n;
    colour += w * Vec3d{static_cast<double>(c.r), static_cast<double>(c.g), static_cast<double>(c.b)};
  }
  const auto single = [](const Vec3d& v) {
    return Vec3f{static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
  };
  const double l = length(normal);
  h.value = 0.5 * (value + (l > 0 ? dot(normal, offset) / l : value)) / weight;
  h.normal = single(normal);
  h.colour = single(colour / weight);
  h.known = true;
  return h;
}

}  // namespace thaw
