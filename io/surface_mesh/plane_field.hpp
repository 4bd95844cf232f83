// SPDX-License-Identifier: Apache-2.0
// Implicit surface of surfels: the weighted mean of their planes.
#pragma once
#include <functional>
#include <vector>

#include "core/surface/search/bins.hpp"
#include "io/frames/read_surface_frame.hpp"
#include "io/surface_mesh/band_grid.hpp"

namespace thaw {

inline constexpr double planeSharpness = 0.6;  ///< width of the weights, in radii of the surfel
/// Least cosine of a normal to that of the nearest surfel: excludes the other side of a thin sheet.
inline constexpr float planeAgreement = -0.3f;
/// Radii within which surfels count, plus `margin`.
inline constexpr double planeReach = 1.5;

/// Signed height over the surface (m, above 0 outside), and its outward gradient, not normalised. Also the
/// mean colour (sRGB 0 to 255); `known` is false if no surfel is in reach.
struct PlaneHeight {
  double value = 0;
  Vec3f normal{}, colour{};
  bool known = false;
};

/// Signed distance (m) to the obstacles that end a surface, above 0 outside of them, and its gradient.
using ObstacleDistance = std::function<double(const Vec3d& x, Vec3d& gradient)>;

/// Implicit moving least squares (KO05) over the nearest surfels, corrected for curvature by the
/// mean normal. Planes of a curved surface lie outside of it. The chord to a surfel is perpendicular to the
/// mean of both normals, on a sphere exactly.
class PlaneField {
 public:
  /// Reads positions, normals, radii and colours of the frame. margin: m. obstacles: empty for none.
  PlaneField(const SurfaceFrame& frame, double margin, ObstacleDistance obstacles = {});
  PlaneHeight at(const Vec3d& x) const;
  /// Returns whether a disc with a similar normal covers the position.
  bool onDisc(const Vec3d& x, const Vec3f& normal) const;

 private:
  const SurfaceFrame& frame_;
  double margin_, farthest_ = 0;
  ObstacleDistance obstacles_;
  Bins bins_;
};

/// The surface around corners of a grid, one entry per slot.
struct BandHeights {
  std::vector<double> values;  ///< m
  std::vector<Vec3f> normals;  ///< unit
  std::vector<Vec3f> colours;  ///< sRGB 0 to 255
};

/// Makes a slot for each corner in reach of a surfel, with the spacing of the grid as the margin. Returns
/// PlaneField::at there, up to rounding, in one pass over the surfels.
BandHeights heightsAround(const SurfaceFrame& frame, BandGrid& grid, const ObstacleDistance& obstacles = {});

}  // namespace thaw
