// SPDX-License-Identifier: Apache-2.0
#include "io/surface_mesh/plane_field.hpp"

#include <cmath>
#include <limits>

namespace thaw {

PlaneField::PlaneField(const SurfaceFrame& frame, const std::vector<std::uint32_t>& rows, double margin)
    : frame_(frame), rows_(rows), margin_(margin) {
  std::vector<Vec3d> places;
  for (const std::uint32_t i : rows) {
    places.push_back(frame.positions[i]);
    farthest_ = std::max(farthest_, planeReach * frame.radii[i] + margin);
  }
  fillBins(places.data(), places.size(), farthest_, bins_);
}

bool PlaneField::onDisc(const Vec3d& x, const Vec3f& normal) const {
  bool on = false;
  forRowsWithin(bins_, x, farthest_, [&](std::uint32_t k, double) {
    const std::uint32_t i = rows_[k];
    const Vec3f& m = frame_.normals[i];
    const Vec3d away = x - frame_.positions[i];
    const double r = frame_.radii[i], along = dot(away, Vec3d{m.x, m.y, m.z}),
                 beside2 = dot(away, away) - along * along;
    on = on || (dot(m, normal) > 0.5f && std::abs(along) < 0.3 * r && beside2 < r * r);
  });
  return on;
}

PlaneHeight PlaneField::at(const Vec3d& x) const {
  const auto forNear = [&](auto use) {
    forRowsWithin(bins_, x, farthest_, [&](std::uint32_t k, double d2) {
      const std::uint32_t i = rows_[k];
      const double reach = planeReach * frame_.radii[i] + margin_;
      if (d2 < reach * reach) use(i, d2);
    });
  };
  double nearest2 = std::numeric_limits<double>::infinity();
  std::uint32_t nearest = 0;
  forNear([&](std::uint32_t i, double d2) {
    if (d2 < nearest2) nearest2 = d2, nearest = i;
  });
  PlaneHeight h;
  if (!(nearest2 < std::numeric_limits<double>::infinity())) return h;
  double weight = 0, value = 0;
  Vec3d offset{}, normal{};
  forNear([&](std::uint32_t i, double d2) {
    const Vec3f& m = frame_.normals[i];
    if (dot(m, frame_.normals[nearest]) < planeAgreement) return;
    const double width = planeSharpness * frame_.radii[i];
    const double w = std::exp(std::max(-60.0, (nearest2 - d2) * 0.5 / (width * width)));
    const Vec3d n{m.x, m.y, m.z}, away = x - frame_.positions[i];
    weight += w;
    value += w * dot(away, n);
    offset += w * away;
    normal += w * n;
  });
  const double l = length(normal);
  h.value = 0.5 * (value + (l > 0 ? dot(normal, offset) / l : value)) / weight;
  h.normal = {static_cast<float>(normal.x), static_cast<float>(normal.y), static_cast<float>(normal.z)};
  h.known = true;
  return h;
}

}  // namespace thaw
