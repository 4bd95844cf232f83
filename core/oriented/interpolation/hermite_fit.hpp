// SPDX-License-Identifier: Apache-2.0
// Hermite interpolation of points with normals by radial functions r^3 (W05, MGV11). f = 0 on the surface,
// and the gradient of f there is the normal. A partition of unity (O03) blends pieces around each point.
#pragma once
#include <vector>

#include "core/math/vec3.hpp"

namespace thaw {

/// Interpolant of the points near one of them.
struct HermitePiece {
  Vec3d centre{};              ///< m
  double scale = 1;            ///< m, unit of lengths
  std::vector<Vec3d> points;   ///< 1, relative to the centre
  std::vector<double> weight;  ///< four per point: one for r^3, three for its gradient
};

/// Value f (m, approximately the signed distance) and gradient.
struct HermiteValue {
  double value;
  Vec3d gradient;
};

/// Fits a piece to points (m) with unit normals. scale: m, about the points' spacing. Returns a piece without
/// points if the system is singular.
HermitePiece hermitePiece(const Vec3d& centre, double scale, const std::vector<Vec3d>& points,
                          const std::vector<Vec3d>& normals);

HermiteValue valueOf(const HermitePiece& piece, const Vec3d& place);

}  // namespace thaw
