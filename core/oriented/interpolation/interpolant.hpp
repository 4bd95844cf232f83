// SPDX-License-Identifier: Apache-2.0
// Interpolated surface of given points, and normals for points without normals (ST92).
#pragma once
#include <memory>
#include <vector>

#include "core/geometry/trees/point_tree.hpp"
#include "core/oriented/interpolation/hermite_fit.hpp"

namespace thaw {

/// Given points and their local interpolants; the same on all ranks.
struct PointInterpolant {
  std::vector<Vec3d> points, normals;  ///< m, unit
  std::shared_ptr<const PointTree> tree;
  std::vector<HermitePiece> pieces;  ///< one per point; empty where the system is singular
  double apart = 0;                  ///< m, mean distance to the nearest neighbour
  double reach = 2.5;  ///< 1, largest distance from the points at which the surface exists, over `apart`
};

/// Computes tree, mean distance and pieces.
void buildInterpolant(PointInterpolant& given);

/// Returns unit normals for points (m) without normals. Each is the normal of the plane of the 12 nearest
/// points. A minimal spanning tree over differences of normals orients the normals (H92). It starts at the
/// highest point, whose normal points up (docs/validation/stability.md, row 17).
std::vector<Vec3d> normalsOf(const std::vector<Vec3d>& points);

/// Moves a position (m) onto the interpolated surface, and sets the normal there. Returns false if no point
/// is within reach, or if the interpolant has no surface.
bool projectOnInterpolant(const PointInterpolant& given, Vec3d& place, Vec3d& normal);

/// Thin plate through points (D77): height above the plane of best fit; see thinPlate.
struct ThinPlate {
  Vec3d origin{}, u{}, v{}, n{};     ///< m; unit vectors in the plane, and its normal
  std::vector<double> x, y, weight;  ///< m, coordinates of the points in the plane, and spline weights
  double constant = 0, perX = 0, perY = 0;
  double height(double px, double py) const;
  Vec3d at(double px, double py) const { return origin + px * u + py * v + height(px, py) * n; }
  Vec3d normal(double px, double py) const;
};
/// Throws std::invalid_argument for fewer than three points or collinear ones.
ThinPlate thinPlate(const std::vector<Vec3d>& points);

}  // namespace thaw
