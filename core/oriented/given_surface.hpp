// Points that a surface is to go through: their normals, and the smooth surface that they suggest (3D
// interpolation, ST92).
#pragma once
#include <memory>
#include <vector>

#include "core/geometry/point_tree.hpp"
#include "core/oriented/hermite_fit.hpp"

namespace thaw {

/// The same on all ranks.
struct GivenPoints {
  std::vector<Vec3d> points, normals;
  std::shared_ptr<const PointTree> tree;
  std::vector<HermitePiece> pieces;  ///< of each point; without points where there is none
  double apart = 0;                  ///< m, mean distance to the nearest other one
  double reach = 2.5;                ///< 1, of it: how far from all points there is still a surface
};

/// Makes tree, distance and pieces.
void readyGiven(GivenPoints& given);

/// Unit normals of points without any: of the plane of the 12 nearest, turned the same way along a minimal
/// spanning tree of neighbours whose normals differ least, from the highest point (its normal up) on (Hoppe
/// et al. 1992); docs/validation/stability.md B17.
std::vector<Vec3d> normalsOf(const std::vector<Vec3d>& points);

/// Moves a place onto the surface through the points around, and gives the normal there. False where there is
/// no point within reach, or the points suggest no surface.
bool projectOnGiven(const GivenPoints& given, Vec3d& place, Vec3d& normal);

/// Heights of a thin plate through points (Duchon 1977): height(x, y) of the plane that fits best; see
/// sampleControl.
struct ThinPlate {
  Vec3d origin{}, u{}, v{}, n{};
  std::vector<double> x, y, weight;  ///< of the points in the plane
  double constant = 0, perX = 0, perY = 0;
  double height(double px, double py) const;
  Vec3d at(double px, double py) const { return origin + px * u + py * v + height(px, py) * n; }
  Vec3d normal(double px, double py) const;
};
/// Needs at least three points not on a line, else std::invalid_argument.
ThinPlate thinPlate(const std::vector<Vec3d>& points);

}  // namespace thaw
