// SPDX-License-Identifier: Apache-2.0
// Unwraps a component along periodic axes. The domain is cut open in the widest gap of the component.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "core/neighbours/grid.hpp"

namespace thaw {

/// Bits of the occupied sectors of the domain along each periodic axis. They do not depend on the order of
/// rows. Sectors of parts are combined by |.
using Sectors = std::array<std::uint64_t, 3>;

/// Returns the number of sectors of an axis, at most 64. Each is at least `least` (m) wide, so an empty
/// sector is wider than the distance of neighbours.
inline int sectorCount(const CellGrid& g, int axis, double least) {
  return static_cast<int>(std::clamp(g.period[axis] / least, 1.0, 64.0));
}

/// Returns the coordinate relative to the low side of the domain, wrapped into [0, period) (m). Requires: a
/// periodic axis.
inline double withinPeriod(const CellGrid& g, int axis, double x) {
  const double u = x - g.origin[axis], wrapped = u - g.period[axis] * std::floor(u / g.period[axis]);
  // Rounding may give a full period.
  return wrapped < g.period[axis] ? wrapped : 0;
}

inline void addToSectors(const CellGrid& g, double least, const Vec3d& x, Sectors& sectors) {
  for (int a = 0; a < 3; a++) {
    if (!g.periodic[a]) continue;
    const int n = sectorCount(g, a, least),
              s = std::min(n - 1, static_cast<int>(withinPeriod(g, a, x[a]) / g.period[a] * n));
    sectors[static_cast<std::size_t>(a)] |= std::uint64_t{1} << s;
  }
}

/// Position of a component's cut along each axis.
struct PeriodicCut {
  /// true for a periodic axis along which the component has no gap
  std::array<bool, 3> round{};
  /// m, relative to the low side: middle of the widest gap, where the domain is cut; 0 without a gap
  Vec3d from{};
};

inline PeriodicCut findPeriodicCut(const CellGrid& g, double least, const Sectors& sectors) {
  PeriodicCut p;
  for (int a = 0; a < 3; a++) {
    if (!g.periodic[a]) continue;
    const int n = sectorCount(g, a, least);
    // number and first index of consecutive empty sectors
    int widest = 0, at = 0;
    for (int first = 0; first < n; first++) {
      int many = 0;
      while (many < n && !(sectors[static_cast<std::size_t>(a)] >> ((first + many) % n) & 1)) many++;
      if (many > widest) widest = many, at = first;
    }
    p.round[static_cast<std::size_t>(a)] = widest == 0;
    if (widest > 0) p.from[a] = std::fmod((at + 0.5 * widest) / n, 1.0) * g.period[a];
  }
  return p;
}

/// Returns x (m) shifted by periods to its position in the unwrapped component. Along periodic axes, it is
/// between the cut and one period beyond.
inline Vec3d unwrappedPosition(const CellGrid& g, const PeriodicCut& p, Vec3d x) {
  for (int a = 0; a < 3; a++) {
    if (!g.periodic[a]) continue;
    double u = withinPeriod(g, a, x[a]);
    if (u < p.from[a]) u += g.period[a];
    x[a] = g.origin[a] + u;
  }
  return x;
}

}  // namespace thaw
