// SPDX-License-Identifier: Apache-2.0
// Loops over the particles of the free surface. surfaceGradient is the outward normal times the weight of a
// particle in sums over the surface; 0 inside.
#pragma once
#include <algorithm>

#include "core/flow/curvature/surface_curvature.hpp"

namespace thaw {

/// Returns the weight of a particle in sums over the surface.
inline double weightOf(const Continuum& p, std::uint32_t j) { return length(p.surfaceGradient[j]); }

/// Calls row(i, group, lane) for each owned row with neighbour lists.
template<class Row> void eachRow(const CurvatureContext& x, Row&& row) {
  const NeighbourLists& lists = x.neighbours;
  for (std::size_t g = 0; g < lists.groups; g++)
    for (std::size_t l = 0; l < 8; l++)
      if (const std::uint32_t i = lists.self[8 * g + l]; i != lists.dummy) row(i, g, l);
}
/// Calls row(i, group, lane) for each owned row at the surface.
template<class Row> void eachAtSurface(const CurvatureContext& x, Row&& row) {
  eachRow(x, [&](std::uint32_t i, std::size_t g, std::size_t l) {
    if (weightOf(x.world.particles, i) > 0) row(i, g, l);
  });
}

/// Calls pair(j, d) for each neighbour at the surface, d = (x_j - x_i) / h.
template<class Pair>
void eachNeighbour(const CurvatureContext& x, std::uint32_t i, std::size_t g, std::size_t l, Pair&& pair) {
  const NeighbourLists& lists = x.neighbours;
  const Continuum& p = x.world.particles;
  for (std::uint32_t k = 0; k < lists.count[g]; k++) {
    const std::uint32_t j = lists.row(g, k, l);
    if (j == lists.dummy || p.surfaceGradient[j] == Vec3d{}) continue;
    const Vec3d d = (p.position[j] - p.position[i]) / x.world.grid.support;
    if (dot(d, d) < 1) pair(j, d);
  }
}

/// Returns true if a row has solid neighbours.
inline bool hasSolidNeighbour(const CurvatureContext& x, std::size_t g, std::size_t l) {
  const NeighbourLists& lists = x.neighbours;
  const Continuum& p = x.world.particles;
  for (std::uint32_t k = 0; k < lists.count[g]; k++)
    if (const std::uint32_t j = lists.row(g, k, l); j != lists.dummy && p.phase[j] != Liquid) return true;
  return false;
}

/// Returns the wall's share (1) of the force on a particle: 1 on the wall, 0 beyond 1.5 spacings.
inline double shareOfWall(const CurvatureContext& x, const WallContact& c) {
  constexpr double wholeUpTo = 0.75, noneFrom = 1.5;  // distances in spacings
  return std::clamp((noneFrom - c.distance / x.world.scene.spacing) / (noneFrom - wholeUpTo), 0.0, 1.0);
}

/// Returns 0 up to `from`, 1 beyond `to`, and a smooth cubic in between.
inline double smoothStep(double from, double to, double x) {
  const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

/// Returns 1 for particles at the same face of a surface, and 0 for particles at opposite faces of a film. a,
/// b: vectors along their normals. The transition lies between angles of 60 and 120 degrees.
inline double sameFace(const Vec3d& a, const Vec3d& b) {
  const double size = length(a) * length(b);
  return size > 0 ? smoothStep(-0.5, 0.5, dot(a, b) / size) : 1;
}

}  // namespace thaw
