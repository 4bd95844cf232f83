// Directions out of the body at particles near its surface, from where the neighbours lie: shades a lattice of spheres as one surface.
#pragma once
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
    const std::uint32_t h = static_cast<std::uint32_t>(x) * 73856093u ^ static_cast<std::uint32_t>(y) * 19349663u ^ static_cast<std::uint32_t>(z) * 83492791u;
    return (h ^ (h >> 15)) & mask;
  }
};

CellBins binParticles(std::span<const Vec3f> positions, float edge);

/// Distance (m) to the nearest other particle within the bins' edge; infinite if there is none.
float nearestNeighbour(std::span<const Vec3f> positions, const CellBins& bins, const Vec3f& from);

/// Normal of the surface and how much of a surface there is: 0 inside a body or for a lone particle, 1 at a clear surface.
struct SurfaceNormal { Vec3f normal; float strength = 0; };

/// At the particles `which`, over neighbours nearer than the bins' edge.
std::vector<SurfaceNormal> surfaceNormals(std::span<const Vec3f> positions, std::span<const std::uint32_t> which, const CellBins& bins);

/// Averages values and normals of `which` over each other where they look alike, over the bins' edge. Particles not in `which` do not count.
struct Smoothed { std::vector<SurfaceNormal> normals; std::vector<float> values; };
Smoothed smoothOver(std::span<const Vec3f> positions, std::span<const std::uint32_t> which, const CellBins& bins, const Smoothed& raw);

}  // namespace thaw
