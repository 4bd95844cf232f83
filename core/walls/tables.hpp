// What a half-space of wall contributes to the sums of a particle at a distance d, in units of the support radius h, as tables
// over d / h. There are no wall particles: near a smooth wall the missing part of a kernel's support is a spherical cap, and its
// integrals are known once the kernel is.
#pragma once
#include <vector>

#include "core/scene/scene.hpp"

namespace thaw {

/// Values at one distance. filling: int W dV (1); push: -d filling / d(distance) (1/h); drag: int lap W (1 + z/d) dV (1/h^2), the Laplacian
/// of a field that is linear across the wall's surface (Morris 1997), z the depth in the wall.
struct WallIntegrals { double filling = 0, push = 0, drag = 0; };

struct WallTables {
  static constexpr int points = 512;
  std::vector<WallIntegrals> at;  ///< at distances k / points, k = 0 ... points
  double nearest = 0.05;          ///< distances (h) below are taken as this in drag, which grows like 1 / d

  /// distance in units of h; nothing beyond 1, the value at 0 below 0.
  WallIntegrals operator()(double distance) const {
    if (distance >= 1) return {};
    const double x = (distance > 0 ? distance : 0) * points;
    const int k = static_cast<int>(x) < points ? static_cast<int>(x) : points - 1;
    const double t = x - k;
    const WallIntegrals &a = at[static_cast<std::size_t>(k)], &b = at[static_cast<std::size_t>(k) + 1];
    return {a.filling + t * (b.filling - a.filling), a.push + t * (b.push - a.push), a.drag + t * (b.drag - a.drag)};
  }
};

/// spacing: in units of h; drag takes distances below a quarter of it as that.
WallTables makeWallTables(KernelKind kernel, double spacing);

}  // namespace thaw
