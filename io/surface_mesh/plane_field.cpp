// SPDX-License-Identifier: Apache-2.0
#include "io/surface_mesh/plane_field.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace thaw {

namespace {

/// A surfel as it is summed.
struct Plane {
  Plane(const SurfaceFrame& frame, std::size_t i)
      : normal(wide(frame.normals[i])),
        colour{double(frame.colours[i].r), double(frame.colours[i].g), double(frame.colours[i].b)},
        sharpness(0.5 / (planeSharpness * frame.radii[i] * planeSharpness * frame.radii[i])) {}
  Vec3d normal, colour;
  double sharpness;  ///< 1/m^2
};

/// Weighted sums of the planes around a position.
struct PlaneSums {
  double weight = 0, value = 0;
  Vec3d offset{}, normal{}, colour{};

  /// Adds a plane at a vector `away` from it. nearest2: m^2, square of the distance to the nearest surfel.
  /// Weights are relative to that one, so they do not vanish far from the surface.
  void add(const Plane& plane, const Vec3d& away, double nearest2) {
    const double w = std::exp(std::max(-60.0, (nearest2 - dot(away, away)) * plane.sharpness));
    weight += w;
    value += w * dot(away, plane.normal);
    offset += w * away;
    normal += w * plane.normal;
    colour += w * plane.colour;
  }
  double height() const {
    const double l = length(normal);
    return 0.5 * (value + (l > 0 ? dot(normal, offset) / l : value)) / weight;
  }
};

/// Ends the surface where obstacles begin: planes of sharp edges meet beyond the surfels, in the obstacle.
void endAtObstacles(const ObstacleDistance& obstacles, const Vec3d& x, double& height, Vec3f& normal) {
  if (!obstacles) return;
  Vec3d gradient{};
  const double inside = -obstacles(x, gradient);
  if (inside > height) height = inside, normal = single(-gradient);
}

}  // namespace

PlaneField::PlaneField(const SurfaceFrame& frame, double margin, ObstacleDistance obstacles)
    : frame_(frame), margin_(margin), obstacles_(std::move(obstacles)) {
  for (const float radius : frame.radii) farthest_ = std::max(farthest_, planeReach * radius + margin);
  fillBins(frame.positions.data(), frame.positions.size(), 0.5 * farthest_, bins_);
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
  PlaneSums sums;
  for (const auto& [i, d2] : near)
    if (!(dot(frame_.normals[i], frame_.normals[nearest]) < planeAgreement))
      sums.add(Plane(frame_, i), x - frame_.positions[i], nearest2);
  h.value = sums.height();
  h.normal = single(sums.normal);
  h.colour = single(sums.colour / sums.weight);
  h.known = true;
  endAtObstacles(obstacles_, x, h.value, h.normal);
  return h;
}

BandHeights heightsAround(const SurfaceFrame& frame, BandGrid& grid, const ObstacleDistance& obstacles) {
  const auto reach = [&](std::size_t i) { return planeReach * frame.radii[i] + grid.spacing(); };
  struct Nearest {
    double distance2 = std::numeric_limits<double>::infinity();
    std::size_t row = 0;
    Vec3d place{};
  };
  std::vector<Nearest> nearest;
  for (std::size_t i = 0; i < frame.radii.size(); i++)
    grid.forCornersNear(frame.positions[i], reach(i), [&](const BandGrid::Corner& c, const Vec3d& away) {
      const auto slot = static_cast<std::size_t>(grid.makeSlot(c));
      if (slot >= nearest.size()) nearest.push_back({});
      if (dot(away, away) < nearest[slot].distance2)
        nearest[slot] = {dot(away, away), i, frame.positions[i] + away};
    });
  std::vector<PlaneSums> sums(nearest.size());
  for (std::size_t i = 0; i < frame.radii.size(); i++) {
    const Plane plane(frame, i);
    grid.forCornersNear(frame.positions[i], reach(i), [&](const BandGrid::Corner& c, const Vec3d& away) {
      const auto slot = static_cast<std::size_t>(grid.slotOf(c));
      const Nearest& at = nearest[slot];
      if (!(dot(frame.normals[i], frame.normals[at.row]) < planeAgreement))
        sums[slot].add(plane, away, at.distance2);
    });
  }
  BandHeights heights;
  for (std::size_t slot = 0; slot < sums.size(); slot++) {
    const PlaneSums& s = sums[slot];
    heights.values.push_back(s.height());
    const double l = length(s.normal);
    heights.normals.push_back(l > 0 ? single(s.normal / l) : Vec3f{});
    endAtObstacles(obstacles, nearest[slot].place, heights.values.back(), heights.normals.back());
    heights.colours.push_back(single(s.colour / s.weight));
  }
  return heights;
}

}  // namespace thaw
