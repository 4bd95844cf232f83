// A smooth surface through points with normals: f = 0 on it, and its gradient there is the normal (Hermite
// interpolation by radial functions, Wendland 2005, Macedo, Gois & Velho 2011, with r^3), in pieces around
// each point that are blended (partition of unity, Ohtake et al. 2003).
#pragma once
#include <vector>

#include "core/math/vec3.hpp"

namespace thaw {

/// One piece: of the points around one of them.
struct HermitePiece {
  Vec3d centre{};
  double scale = 1;            ///< m, what lengths are divided by
  std::vector<Vec3d> points;   ///< 1, from the centre
  std::vector<double> weight;  ///< of each point one of r^3 and three of its gradient
};

/// f (m, about the distance) and its gradient at a place.
struct HermiteValue {
  double value;
  Vec3d gradient;
};

/// Through points with these unit normals; `scale` about their distance (m). Empty (no points) where the
/// system has no solution.
HermitePiece hermitePiece(const Vec3d& centre, double scale, const std::vector<Vec3d>& points,
                          const std::vector<Vec3d>& normals);

HermiteValue valueOf(const HermitePiece& piece, const Vec3d& place);

}  // namespace thaw
