// SPDX-License-Identifier: Apache-2.0
// Depth map of a distant light: for each cell across its direction, the depth of the nearest particle.
#pragma once
#include <array>
#include <span>
#include <vector>

#include "core/math/vec3.hpp"

namespace thaw {

struct DepthMap {
  Vec3f across, along, toLight;  ///< orthonormal; toLight points to the light
  float left = 0, low = 0;       ///< m, coordinates of the map's corner along the first two axes
  float cell = 1;                ///< m, edge of a cell
  int columns = 0, rows = 0;
  std::vector<float> nearest;  ///< m along toLight, of the particle nearest to the light; lowest float if
                               ///< none

  /// Returns the unshadowed fraction, 0 to 1, from (2 taps + 1)^2 bilinear samples around a point. Occluders
  /// need more than `bias` (m) of distance.
  float visible(const Vec3f& point, float bias, int taps) const;
};

/// Discs to draw into a map.
struct Discs {
  std::span<const Vec3f> positions;  ///< m
  std::span<const float> radii;      ///< m, one per disc, or one for all
  std::span<const Vec3f> normals;    ///< unit; empty: discs face the light or camera, like spheres
  /// Triangles that cast shadows, too; counter-clockwise seen from outside.
  std::span<const std::array<Vec3f, 3>> triangles{};
  float radius(std::size_t i) const { return radii.size() == 1 ? radii[0] : radii[i]; }
};

/// Returns the map of all discs and triangles for light from direction `toLight` (unit vector). It has about
/// `cellsPerRadius` cells per typical radius, and at most `limit` columns and rows. Discs and triangles that
/// face away from the light are skipped; a closed surface needs none.
DepthMap makeDepthMap(const Discs& discs, const Vec3f& toLight, float cellsPerRadius, int limit);

}  // namespace thaw
