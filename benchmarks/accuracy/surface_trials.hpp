// What the cases of the surface share: all surfels in one place, and distances between them and exact
// surfaces.
#pragma once
#include "benchmarks/accuracy/trial.hpp"
#include "core/surface/bins.hpp"

namespace thaw::accuracy {

/// A surfel as the figures need it.
struct CloudSurfel {
  std::uint64_t id;
  Vec3d position, normal;
  double radius, area;
  std::uint64_t component;
};

/// The surfels of all ranks on every rank, ascending by id: figures have the same bits on any number of
/// ranks.
struct SurfelCloud {
  std::vector<CloudSurfel> surfels;
  Bins bins;
  std::vector<Vec3d> at;  ///< of the bins
  double reach = 0;       ///< m, within which discs are looked for
};

/// Collective.
SurfelCloud cloudOf(Trial& trial);

/// Distance (m) of a point to the nearest surfel's middle: a point that no disc covers is farther from it
/// than r_s. never: farther than `reach`.
double toNearest(const SurfelCloud& cloud, const Vec3d& x);

/// Distance (m) of a point to the surface that the discs are.
double toDiscs(const SurfelCloud& cloud, const Vec3d& x);

/// Surfels within h_ss of a surfel, itself left out, in the mean.
double meanNeighbours(const SurfelCloud& cloud, double radius);

/// How far an exact surface, given by points on it, is from the discs, and how far from a point the nearest
/// surfel's middle is along the surface at the most: more than r_s is a hole. What the discs are off the
/// exact surface is not counted in that.
struct FromExact {
  double distance = 0, hole = 0;  // m
};
FromExact fromExact(const SurfelCloud& cloud, const std::vector<Vec3d>& points);

/// n points on the unit ball, evenly.
std::vector<Vec3d> ballPoints(std::size_t n);

/// Degrees between two unit vectors.
double degreesBetween(const Vec3d& a, const Vec3d& b);

/// Sums over components: volumes in the surface and of the particles, areas.
double surfaceVolume(const World& world);
double particleVolume(const World& world);
double surfaceArea(const World& world);

/// What the surface cost: neighbours, and core-microseconds an update and surfel. To be appended to the
/// figures of a case. Collective.
void addCost(Trial& trial, const SurfelCloud& cloud, std::vector<Figure>& figures);

std::vector<Case> restingSurfaceCases();  ///< ball, cube, sheet
std::vector<Case> movingSurfaceCases();   ///< spin, melt, merge, split, held

}  // namespace thaw::accuracy
