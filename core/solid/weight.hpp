// Weight of a bond and its vector across periodic sides.
#pragma once
#include <limits>

#include "core/math/vec3.hpp"
#include "core/neighbours/grid.hpp"

namespace thaw {

/// w = (1 - r^2/h^2)^3, 0 from r = 0.9995 h on; 1. Not normalised: only ratios of weights matter. The bits
/// are the same for X and -X. A neighbour on a lattice can lie at h to rounding: its weight of some 1e-44
/// must not be all that a particle has left when the others have melted, since a float cannot hold its
/// inverse.
inline double bondWeight(const Vec3d& reference, double support) {
  const double q = 1 - dot(reference, reference) / (support * support);
  return q > 1e-3 ? q * q * q : 0;
}

/// Lengths of the domain along its periodic axes, m; 0: not periodic.
struct Periods {
  Vec3d length{};
};
inline Periods periodsOf(const CellGrid& grid) {
  Periods p;
  for (int a = 0; a < 3; a++) p.length[a] = grid.periodic[a] ? grid.period[a] : 0;
  return p;
}

/// The shortest of the periodic images of d. minimumImage(-d) = -minimumImage(d), bit by bit. |d| less than
/// 3/2 periods.
inline Vec3d minimumImage(Vec3d d, const Periods& periods) {
  for (int a = 0; a < 3; a++) {
    const double p = periods.length[a];
    if (p > 0) d[a] = d[a] > p / 2 ? d[a] - p : d[a] < -p / 2 ? d[a] + p : d[a];
  }
  return d;
}

}  // namespace thaw
