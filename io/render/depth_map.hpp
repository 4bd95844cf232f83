// What a light far away sees: for each place across its direction, how near to the light the nearest particle
// is.
#pragma once
#include <span>
#include <vector>

#include "core/math/vec3.hpp"

namespace thaw {

struct DepthMap {
  Vec3f across, along, toLight;  ///< orthonormal; toLight points at the light
  float left = 0, low = 0;       ///< m, coordinates of the map's corner along the first two axes
  float cell = 1;                ///< m, edge of a cell
  int columns = 0, rows = 0;
  std::vector<float> nearest;  ///< m, along toLight, of the particle nearest to the light; lowest float where
                               ///< there is none

  /// Part of the light, 0 to 1, that passes: over (2 taps + 1)^2 bilinear samples around a point that is
  /// `bias` metres in front of it.
  float visible(const Vec3f& point, float bias, int taps) const;
};

/// Discs to draw into a map.
struct Discs {
  std::span<const Vec3f> positions;  ///< m
  std::span<const float> radii;      ///< m, one a disc, or one for all
  std::span<const Vec3f> normals;    ///< unit; empty: each faces the light or the camera, as spheres seem to
  float radius(std::size_t i) const { return radii.size() == 1 ? radii[0] : radii[i]; }
};

/// The map of all discs for light from direction `toLight` (a unit vector), with about `cellsPerRadius` cells
/// to a typical radius but at most `limit` columns and rows. Of discs with normals, those turned away from
/// the light are left out: a closed surface needs none.
DepthMap makeDepthMap(const Discs& discs, const Vec3f& toLight, float cellsPerRadius, int limit);

}  // namespace thaw
