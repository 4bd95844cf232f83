// SPDX-License-Identifier: Apache-2.0
// Weight of a bond, and bond vectors across periodic sides.
#pragma once
#include <limits>

#include "core/math/vec3.hpp"
#include "core/neighbours/grid.hpp"

namespace thaw {

/// Returns the weight w = (1 - r^2/h^2)^3 (1), or 0 for r >= 0.9995 h. It is not normalised, since only
/// ratios of weights matter. X and -X give the same bits. The cutoff excludes lattice neighbours whose
/// distance is h up to rounding. Otherwise a weight near 1e-44 could be the only one left after melting, and
/// a float cannot store its inverse.
inline double bondWeight(const Vec3d& reference, double support) {
  const double q = 1 - dot(reference, reference) / (support * support);
  return q > 1e-3 ? q * q * q : 0;
}

/// Lengths of the domain along its periodic axes (m); 0: not periodic.
struct Periods {
  Vec3d length{};
};
inline Periods periodsOf(const CellGrid& grid) {
  Periods p;
  for (int a = 0; a < 3; a++) p.length[a] = grid.periodic[a] ? grid.period[a] : 0;
  return p;
}

/// Returns the shortest periodic image of d; minimumImage(-d) = -minimumImage(d) bit by bit. Requires: |d|
/// less than 3/2 periods.
inline Vec3d minimumImage(Vec3d d, const Periods& periods) {
  for (int a = 0; a < 3; a++) {
    const double p = periods.length[a];
    if (p > 0) d[a] = d[a] > p / 2 ? d[a] - p : d[a] < -p / 2 ? d[a] + p : d[a];
  }
  return d;
}

}  // namespace thaw
