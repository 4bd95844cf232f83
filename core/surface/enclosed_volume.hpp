// The volume that surfels enclose, from sums over their facets, where there are holes as well.
#pragma once
#include <array>

#include "core/math/mat3.hpp"

namespace thaw {

/// Sums over the surfels of a component; d: from any one place to a surfel (m), f: its facets
/// (Surfels::facets), b: its bulge, r: its rim.
struct FacetSums {
  Vec3d volume{};     ///< m^3, of d_a f_a + b
  Vec3d mixed{};      ///< m^3, of d_y f_z + d_z f_y, and so on
  Vec3d facets{};     ///< m^2, of f
  double rim = 0;     ///< m
  Vec3d rimPlace{};   ///< m^2, of r d
  Sym3d rimSquare{};  ///< m^3, of r d d^T
};

/// m^3. By the divergence theorem each axis tells it: sum d_a f_a; so do all means of them, W : sum d f^T
/// with W symmetric and of trace 1. Where there is no hole, each is as good as the others, and W is a third
/// of the identity. A hole is what is missing in the sum: its area vector, times how far it lies from where d
/// is measured. That is taken from the middle of the rims, and W = (s^2 + covariance of the rims' places)^-1,
/// but for a factor, s half a spacing: of a film with holes all over it the height above its middle plane
/// counts, and not how far apart they are. An axis that the component goes round (periodic) tells nothing,
/// unless all are such. middle: without rims.
double enclosedVolume(const FacetSums& sums, const Vec3d& middle, const std::array<bool, 3>& round,
                      double spacing);

}  // namespace thaw
