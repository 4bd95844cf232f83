// Where a component lies along periodic axes: seen from the widest part of the domain that it leaves free, it
// is in one piece.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "core/neighbours/grid.hpp"

namespace thaw {

/// Sectors of the domain along each periodic axis that a component has rows in, a bit each. The same for any
/// order of the rows, and | of the parts is that of the whole.
using Sectors = std::array<std::uint64_t, 3>;

/// Of an axis: at most 64, each at least `least` (m) wide, so that one without rows is no gap between
/// neighbours.
inline int sectorCount(const CellGrid& g, int axis, double least) {
  return static_cast<int>(std::clamp(g.period[axis] / least, 1.0, 64.0));
}

/// m, from the low side of the domain, in [0, period): only along periodic axes.
inline double withinPeriod(const CellGrid& g, int axis, double x) {
  const double u = x - g.origin[axis], wrapped = u - g.period[axis] * std::floor(u / g.period[axis]);
  return wrapped < g.period[axis] ? wrapped : 0;  // rounded up
}

inline void addToSectors(const CellGrid& g, double least, const Vec3d& x, Sectors& sectors) {
  for (int a = 0; a < 3; a++) {
    if (!g.periodic[a]) continue;
    const int n = sectorCount(g, a, least),
              s = std::min(n - 1, static_cast<int>(withinPeriod(g, a, x[a]) / g.period[a] * n));
    sectors[static_cast<std::size_t>(a)] |= std::uint64_t{1} << s;
  }
}

/// How places of a component are told along each axis.
struct OnePiece {
  std::array<bool, 3> round{};  ///< it has rows in every sector of a periodic axis: it goes round, or nearly
                                ///< so, and is in no one piece
  Vec3d from{};  ///< m from the low side: middle of the widest gap, where the domain is cut open; 0 where it
                 ///< goes round
};

inline OnePiece onePiece(const CellGrid& g, double least, const Sectors& sectors) {
  OnePiece p;
  for (int a = 0; a < 3; a++) {
    if (!g.periodic[a]) continue;
    const int n = sectorCount(g, a, least);
    int widest = 0, at = 0;  // sectors without rows, from `at` on
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

/// x moved by whole periods to where it lies in the one piece: along periodic axes from the low side of the
/// domain plus `from` on.
inline Vec3d placeIn(const CellGrid& g, const OnePiece& p, Vec3d x) {
  for (int a = 0; a < 3; a++) {
    if (!g.periodic[a]) continue;
    double u = withinPeriod(g, a, x[a]);
    if (u < p.from[a]) u += g.period[a];
    x[a] = g.origin[a] + u;
  }
  return x;
}

}  // namespace thaw
