// SPDX-License-Identifier: Apache-2.0
// Outward directions at particles near the surface, from neighbour positions: they shade a lattice of spheres
// as one surface.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "core/math/vec3.hpp"

namespace thaw {

/// Particles by the cell of a hashed grid.
struct CellBins {
  float edge = 1;                      ///< m
  std::uint32_t mask = 0;              ///< number of bins - 1
  std::vector<std::uint32_t> first;    ///< bins + 1
  std::vector<std::uint32_t> members;  ///< by bin, ascending within one

  std::uint32_t bin(int x, int y, int z) const {
    const std::uint32_t h = static_cast<std::uint32_t>(x) * 73856093u ^
                            static_cast<std::uint32_t>(y) * 19349663u ^
                            static_cast<std::uint32_t>(z) * 83492791u;
    return (h ^ (h >> 15)) & mask;
  }
};

/// Returns the cell along an axis. Far positions and not-a-number share one cell, since conversion to int
/// must be defined.
inline int cellAlong(float x, float edge) {
  const float c = std::floor(x / edge);
  return c > -1e9f && c < 1e9f ? static_cast<int>(c) : 1'000'000'000;
}

/// Calls f(j, offset, weight) for all particles j nearer to p than the edge, p included, each once. offset: p
/// - x_j.
template<class F>
void forNeighbours(std::span<const Vec3f> positions, const CellBins& bins, const Vec3f& p, F f) {
  const int cx = cellAlong(p.x, bins.edge), cy = cellAlong(p.y, bins.edge), cz = cellAlong(p.z, bins.edge);
  const float h2 = bins.edge * bins.edge;
  std::uint32_t visited[27];
  int count = 0;
  for (int z = -1; z <= 1; z++)
    for (int y = -1; y <= 1; y++)
      for (int x = -1; x <= 1; x++) {
        const std::uint32_t bin = bins.bin(cx + x, cy + y, cz + z);
        if (std::find(visited, visited + count, bin) != visited + count) continue;  // two cells of one bin
        visited[count++] = bin;
        for (std::uint32_t k = bins.first[bin]; k < bins.first[bin + 1]; k++) {
          const std::uint32_t j = bins.members[k];
          const Vec3f d = p - positions[j];
          const float d2 = dot(d, d);
          if (d2 < h2) f(j, d, (1 - d2 / h2) * (1 - d2 / h2));
        }
      }
}

CellBins binParticles(std::span<const Vec3f> positions, float edge);

/// Returns the distance (m) to the nearest other particle within the bins' edge; infinite if there is none.
float nearestNeighbour(std::span<const Vec3f> positions, const CellBins& bins, const Vec3f& from);

/// Surface normal, and strength of the surface: 0 inside a body or for a lone particle, 1 at a clear surface.
struct SurfaceNormal {
  Vec3f normal;
  float strength = 0;
};

/// Computes normals at the particles `which`, over neighbours nearer than the bins' edge.
std::vector<SurfaceNormal> surfaceNormals(std::span<const Vec3f> positions,
                                          std::span<const std::uint32_t> which, const CellBins& bins);

/// Values and normals of `which`, averaged over neighbours with similar normals within the bins' edge.
/// Particles not in `which` are ignored.
struct Smoothed {
  std::vector<SurfaceNormal> normals;
  std::vector<float> values;
};
Smoothed smoothOver(std::span<const Vec3f> positions, std::span<const std::uint32_t> which,
                    const CellBins& bins, const Smoothed& raw);

}  // namespace thaw
