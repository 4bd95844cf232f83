// SPDX-License-Identifier: Apache-2.0
// Contribution of a wall to the sums of a particle at a distance d. It is tabulated over d / h, in units of
// the support radius h. Walls have no particles. A smooth wall is represented by planes of smeared particles,
// at half a spacing and then at whole spacings below its surface. A particle half a spacing from a wall thus
// has the same relative density as one inside the lattice. An integral over the half-space would differ by
// several per cent.
#pragma once
#include <vector>

#include "core/scene/scene.hpp"

namespace thaw {

/// Values at one distance.
/// - relativeDensity: sum V W (1).
/// - push: sum V |dW/dz| along the normal (1/h). For Wendland's and the cubic kernel it is
///   -d relativeDensity / d(distance).
/// - conduct: sum V lap W (1 + z/d) (1/h^2), with the depth z of a layer. It is the Laplacian of a field that
///   is linear across the wall's surface (MFZ97).
/// - drag: the same for a velocity along the wall, with the scene's viscosity. It is scaled such that
///   layers at distances of one spacing have the total stress mu du/dz in a linear profile. This holds for
///   any position of the first layer.
/// - space: relativeDensity before forLiquids.
/// - momentShare: sum V z |dW/dz| (1), the wall's part of the moment along the normal; z: distance to a
///   layer.
/// - shear: the wall's share (1) of the dissipation of pairs in shear along the wall.
struct WallIntegrals {
  double relativeDensity = 0, push = 0, conduct = 0, drag = 0, space = 0, momentShare = 0, shear = 0;
};

struct WallTables {
  static constexpr int points = 1024;
  double lowest = 0;              ///< h, half a spacing below the surface: lower bound of distances
  double nearest = 0;             ///< h, lower bound of distances in conduct, which grows like 1 / d
  std::vector<WallIntegrals> at;  ///< at distances lowest + k / points * (1 - lowest)

  /// Interpolates at a distance in units of h; zero beyond 1.
  WallIntegrals operator()(double distance) const {
    if (distance >= 1) return {};
    const double x = (distance > lowest ? distance - lowest : 0) / (1 - lowest) * points;
    const int k = static_cast<int>(x) < points ? static_cast<int>(x) : points - 1;
    const double t = x - k;
    const WallIntegrals &a = at[static_cast<std::size_t>(k)], &b = at[static_cast<std::size_t>(k) + 1];
    const auto between = [t](double from, double to) { return from + t * (to - from); };
    return {between(a.relativeDensity, b.relativeDensity),
            between(a.push, b.push),
            between(a.conduct, b.conduct),
            between(a.drag, b.drag),
            between(a.space, b.space),
            between(a.momentShare, b.momentShare),
            between(a.shear, b.shear)};
  }
};

/// Returns the values at a distance (h) without interpolation, exact to rounding.
WallIntegrals wallIntegrals(const Numerics& numerics, double distance);

/// Wall contribution for liquids: relativeDensity^2 / relativeDensity_0, where relativeDensity_0 is the value
/// at half a spacing, and push times 2 relativeDensity / relativeDensity_0. At half a spacing the relative
/// density is unchanged and the push is twice the wall's own, as if the wall had the liquid's pressure. This
/// balances a uniform pressure, which the plain push does not. The push remains the derivative of the
/// relative density, so static walls do no work. Doubling the push alone would make water at rest unstable.
WallIntegrals forLiquids(const WallIntegrals& wall, double onLattice);

/// Distance in spacings below which the contribution for liquids continues along its tangent. The unlimited
/// form is twice as steep a quarter of a spacing from the wall, and four times on it. A few particles in an
/// impact would then limit the step of all particles.
inline constexpr double softBelow = 0.42;

/// Makes tables of forLiquids at distances above softBelow, and of its tangent below. push remains the
/// derivative of relativeDensity. Distances count as at least a quarter of a spacing for conduct, and a
/// twentieth for drag. Interpolation is accurate to 1e-5 except at kinks of drag.
WallTables makeWallTables(const Numerics& numerics);

}  // namespace thaw
