// SPDX-License-Identifier: Apache-2.0
// Volume enclosed by surfels, from sums over their facets. Surfaces may have holes.
#pragma once
#include <array>

#include "core/math/mat3.hpp"

namespace thaw {

/// Sums over the surfels of a component. d: surfel position relative to any fixed point (m), f:
/// Surfels::facets, b: bulge, r: rim.
struct FacetSums {
  Vec3d volume{};     ///< m^3, sum of d_a f_a + b
  Vec3d mixed{};      ///< m^3, sum of d_y f_z + d_z f_y, and cyclic
  Vec3d facets{};     ///< m^2, sum of f
  double rim = 0;     ///< m
  Vec3d rimPlace{};   ///< m^2, sum of r d
  Sym3d rimSquare{};  ///< m^3, sum of r d d^T
};

/// Returns the enclosed volume (m^3). By the divergence theorem each axis gives the volume sum d_a f_a. So
/// does W : sum d f^T for any symmetric W of trace 1. Without holes W is a third of the identity. A hole with
/// area vector h at position p causes the error p . h, so d is relative to the centroid of the rims. With
/// rims, W is proportional to (s^2 + covariance of the rims)^-1, with s of half a spacing. For a film with
/// distributed holes, the height above its middle plane then determines the volume. An axis along which the
/// component spans the periodic domain is ignored, unless this is true for all axes. Without rims, `middle`
/// replaces their centroid.
double enclosedVolume(const FacetSums& sums, const Vec3d& middle, const std::array<bool, 3>& round,
                      double spacing);

}  // namespace thaw
