// What a wall contributes to the sums of a particle at a distance d, in units of the support radius h, as
// tables over d / h. There are no wall particles to keep: a smooth wall is taken as layers of them, half a
// spacing and whole spacings below its surface, each smeared over its plane. So a particle half a spacing
// from a wall has the same filling as one inside the lattice, which an integral over the solid half-space
// would miss by several per cent.
#pragma once
#include <vector>

#include "core/scene/scene.hpp"

namespace thaw {

/// Values at one distance. filling: sum V W (1); push: sum V |dW/dz| along the normal (1/h), with Wendland's
/// and the cubic kernel -d filling / d(distance); conduct: sum V lap W (1 + z/d) (1/h^2), the Laplacian of a
/// field that is linear across the wall's surface (Morris 1997), z the depth of a layer; drag: the same of a
/// velocity along the wall with the scene's viscosity; space: filling before asLiquidsFeelIt. momentShare:
/// sum V z |dW/dz| (1), the wall's part of the moment along the normal; z: distance to a layer. drag is
/// scaled so that layers of particles half a spacing and whole spacings above a wall, in a linear profile,
/// feel mu du/dz in all.
struct WallIntegrals {
  double filling = 0, push = 0, conduct = 0, drag = 0, space = 0, momentShare = 0;
};

struct WallTables {
  static constexpr int points = 1024;
  double lowest = 0;   ///< h, half a spacing below the surface: deeper is taken as this
  double nearest = 0;  ///< h, distances below are taken as this in conduct and drag, which grow like 1 / d
  std::vector<WallIntegrals> at;  ///< at distances lowest + k / points * (1 - lowest)

  /// distance in units of h; nothing beyond 1.
  WallIntegrals operator()(double distance) const {
    if (distance >= 1) return {};
    const double x = (distance > lowest ? distance - lowest : 0) / (1 - lowest) * points;
    const int k = static_cast<int>(x) < points ? static_cast<int>(x) : points - 1;
    const double t = x - k;
    const WallIntegrals &a = at[static_cast<std::size_t>(k)], &b = at[static_cast<std::size_t>(k) + 1];
    const auto between = [t](double from, double to) { return from + t * (to - from); };
    return {between(a.filling, b.filling), between(a.push, b.push),   between(a.conduct, b.conduct),
            between(a.drag, b.drag),       between(a.space, b.space), between(a.momentShare, b.momentShare)};
  }
};

/// The tables' values at a distance (h), without interpolation; exact to rounding.
WallIntegrals wallIntegrals(const Numerics& numerics, double distance);

/// As a liquid feels the wall: filling^2 / filling_0, where filling_0 is that half a spacing from the wall,
/// and push times 2 filling / filling_0. There the filling is the same and the push is twice the wall's own,
/// as if the wall had the liquid's pressure: that balances an even pressure, which once the push does not.
/// And the push is still the slope of the filling, so that the pressure of a still wall does no work;
/// doubling the push alone makes water at rest boil.
WallIntegrals asLiquidsFeelIt(const WallIntegrals& wall, double filling0);

/// Spacings from a wall below which what a liquid feels of it grows along its tangent. The rest would be
/// twice as steep a quarter of a spacing from the wall and four times on it, so that the few particles that
/// an impact drives there would hold the step down for all.
inline constexpr double softBelow = 0.42;

/// Of asLiquidsFeelIt down to softBelow, and on along the tangent: push stays the slope of filling. conduct
/// and drag take distances below a quarter of a spacing as that. Interpolation is good to 1e-5.
WallTables makeWallTables(const Numerics& numerics);

}  // namespace thaw
