// SPDX-License-Identifier: Apache-2.0
// Helpers shared by the surface cases: all surfels on every rank, and their distances from exact surfaces.
#pragma once
#include "benchmarks/accuracy/trial.hpp"
#include "core/surface/search/bins.hpp"

namespace thaw::accuracy {

/// Position, normal and other data of a surfel for the figures.
struct CloudSurfel {
  std::uint64_t id;
  Vec3d position, normal;
  double radius, area;
  std::uint64_t component;
};

/// The surfels of all ranks, ascending by id. The order gives the same bits on any number of ranks.
struct SurfelCloud {
  std::vector<CloudSurfel> surfels;
  Bins bins;
  std::vector<Vec3d> at;  ///< positions in the bins
  double reach = 0;       ///< m, search radius for discs
};

/// Gathers the surfels. Collective.
SurfelCloud cloudOf(Trial& trial);

/// Distance (m) of a point to the nearest surfel's centre; `never` beyond `reach`. Points more than r_s away
/// are uncovered.
double toNearest(const SurfelCloud& cloud, const Vec3d& x);

/// Distance (m) of a point to the nearest disc.
double toDiscs(const SurfelCloud& cloud, const Vec3d& x);

/// Mean number of surfels within h_ss of a surfel, without itself.
double meanNeighbours(const SurfelCloud& cloud, double radius);

/// Distances (m) between an exact surface, given by points on it, and the discs. `distance` is the largest
/// distance of a point to the discs. `hole` is the largest distance along the surface to the nearest surfel's
/// centre; above r_s it is a hole.
struct FromExact {
  double distance = 0, hole = 0;  // m
};
FromExact fromExact(const SurfelCloud& cloud, const std::vector<Vec3d>& points);

/// n evenly distributed points on the unit ball.
std::vector<Vec3d> ballPoints(std::size_t n);

/// Degrees between two unit vectors.
double degreesBetween(const Vec3d& a, const Vec3d& b);

/// Volume enclosed by the surface, volume of the particles, and area, each summed over components.
double surfaceVolume(const World& world);
double particleVolume(const World& world);
double surfaceArea(const World& world);

/// Appends the cost of the surface to the figures: neighbours, and core-microseconds per update and surfel.
/// Collective.
void addCost(Trial& trial, const SurfelCloud& cloud, std::vector<Figure>& figures);

std::vector<Case> restingSurfaceCases();  ///< ball, cube, sheet
std::vector<Case> movingSurfaceCases();   ///< spin, melt, merge, split, held

}  // namespace thaw::accuracy
