// SPDX-License-Identifier: Apache-2.0
// Surfaces at rest against exact shapes: ball, cube, flat sheet.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "benchmarks/accuracy/surface/surface_trials.hpp"

namespace thaw::accuracy {
namespace {

using std::numbers::pi;

/// Targets are set at R/dx = 16. Coarser runs have none.
double bar(const Trial& r, double value) { return r.spacing() < 0.063 ? value : never; }

// ---- ball, radius 1 around the origin ---------------------------------------------------------------------
std::vector<Figure> measureBall(Trial& r) {
  const SurfelCloud cloud = cloudOf(r);
  const FromExact from = fromExact(cloud, ballPoints(8 * cloud.surfels.size()));
  double off = 0, mean = 0, worst = 0, radius = 0;
  for (const CloudSurfel& f : cloud.surfels) {
    const double d = length(f.position) - 1, angle = degreesBetween(f.normal, f.position);
    off = std::max(off, std::abs(d));
    radius += d;
    mean += angle;
    worst = std::max(worst, angle);
  }
  const double n = std::max<double>(1, static_cast<double>(cloud.surfels.size())),
               volume = surfaceVolume(r.world), area = surfaceArea(r.world);
  std::vector<Figure> all{
      {"Hausdorff/R", std::max(off, from.distance), bar(r, 0.01)},
      {"normals mean (deg)", mean / n, bar(r, 1.5)},
      {"normals max (deg)", worst, bar(r, 6)},
      {"area", std::abs(area / (4 * pi) - 1), bar(r, 0.01)},
      {"volume", std::abs(volume / (4 * pi / 3) - 1), bar(r, 0.01)},
      {"largest hole/r_s", from.hole / r.world.surface.spacing, 1},
      {"components - 1", std::abs(static_cast<double>(r.world.surface.components.size()) - 1), 0},
      {"mean offset/R", radius / n},
      {"volume/particles'", volume / particleVolume(r.world)}};
  addCost(r, cloud, all);
  return all;
}

// ---- cube, |x|, |y|, |z| <= 1 -----------------------------------------------------------------------------
double toCube(const Vec3d& x) {
  const Vec3d q{std::abs(x.x) - 1, std::abs(x.y) - 1, std::abs(x.z) - 1};
  const Vec3d out{std::max(q.x, 0.0), std::max(q.y, 0.0), std::max(q.z, 0.0)};
  return std::abs(length(out) + std::min(std::max({q.x, q.y, q.z}), 0.0));
}

/// A lattice on all six faces, edges and corners included.
std::vector<Vec3d> cubePoints(int across) {
  std::vector<Vec3d> points;
  for (int a = 0; a < 3; a++)
    for (int side = -1; side <= 1; side += 2)
      for (int j = 0; j <= across; j++)
        for (int k = 0; k <= across; k++) {
          Vec3d x;
          x[a] = side;
          x[(a + 1) % 3] = 2.0 * j / across - 1;
          x[(a + 2) % 3] = 2.0 * k / across - 1;
          points.push_back(x);
        }
  return points;
}

std::vector<Figure> measureCube(Trial& r) {
  const SurfelCloud cloud = cloudOf(r);
  const double d = r.world.surface.spacing;
  const FromExact from = fromExact(cloud, cubePoints(static_cast<int>(6 / d)));
  double off = 0, worst = 0;
  for (const CloudSurfel& f : cloud.surfels) {
    off = std::max(off, toCube(f.position));
    Vec3d face{};  // outward, where the surfel is more than two spacings from every edge
    int near = 0;
    for (int a = 0; a < 3; a++)
      if (std::abs(f.position[a]) > 1 - 2 * d) face[a] = f.position[a] > 0 ? 1 : -1, near++;
    if (near == 1) worst = std::max(worst, degreesBetween(f.normal, face));
  }
  std::vector<Figure> all{
      {"Hausdorff/edge", 0.5 * std::max(off, from.distance), bar(r, 0.01)},
      {"area", std::abs(surfaceArea(r.world) / 24 - 1), bar(r, 0.01)},
      {"volume", std::abs(surfaceVolume(r.world) / 8 - 1), bar(r, 0.01)},
      {"largest hole/r_s", from.hole / d, 1},
      {"components - 1", std::abs(static_cast<double>(r.world.surface.components.size()) - 1), 0},
      {"normals of faces max (deg)", worst}};
  addCost(r, cloud, all);
  return all;
}

// ---- sheet, |z| <= 1/8, 2 m by 2 m ------------------------------------------------------------------------
std::vector<Figure> measureSheet(Trial& r) {
  const SurfelCloud cloud = cloudOf(r);
  const Surface& s = r.world.surface;
  constexpr double half = 0.125;
  double worst = 0, off = 0, sum[2] = {0, 0}, area[2] = {0, 0};
  for (const CloudSurfel& f : cloud.surfels) {
    const int up = f.position.z > 0;
    worst = std::max(worst, degreesBetween(f.normal, {0, 0, up ? 1.0 : -1.0}));
    off = std::max(off, std::abs(std::abs(f.position.z) - half));
    sum[up] += f.area * f.position.z;
    area[up] += f.area;
  }
  const double thickness = area[0] > 0 && area[1] > 0 ? sum[1] / area[1] - sum[0] / area[0] : 0;
  // away from the periodic sides, where the nearest surfels may be round the corner
  std::vector<Vec3d> points;
  const int across = static_cast<int>(10 / s.spacing);
  for (int j = 0; j <= across; j++)
    for (int k = 0; k <= across; k++)
      for (int side = -1; side <= 1; side += 2)
        points.push_back({0.8 * (2.0 * j / across - 1), 0.8 * (2.0 * k / across - 1), side * half});
  const FromExact from = fromExact(cloud, points);
  std::vector<Figure> all{
      {"thickness", std::abs(thickness / (2 * half) - 1), bar(r, 0.01)},
      {"volume", std::abs(surfaceVolume(r.world) / (8 * half) - 1), bar(r, 0.01)},
      {"area", std::abs(surfaceArea(r.world) / 8 - 1), bar(r, 0.01)},
      {"normals max (deg)", worst, bar(r, 6)},
      {"largest hole/r_s", from.hole / s.spacing, 1},
      {"splits and merges", static_cast<double>(s.counters.splits + s.counters.merges), 0},
      {"components - 1", std::abs(static_cast<double>(s.components.size()) - 1), 0},
      {"thickness/exact", thickness / (2 * half)},
      {"Linf(z)/dx", off / r.spacing()}};
  addCost(r, cloud, all);
  return all;
}

}  // namespace

std::vector<Case> restingSurfaceCases() {
  return {
      {"surface_ball",
       "surface of a ball of liquid, grown from particles; exact ball (K05 4.3)",
       nullptr,
       {},
       {},
       {},
       measureBall},
      {"surface_ball_relaxed",
       "the same in a relaxed packing, without the staircase of a lattice",
       nullptr,
       {},
       {},
       {},
       measureBall},
      {"surface_ball_mesh",
       "surfels sampled from the mesh of a ball; exact ball",
       nullptr,
       {},
       {},
       {},
       measureBall},
      {"surface_cube",
       "surface of a solid cube, one component with its edges; exact cube (stability row 19)",
       nullptr,
       {},
       {},
       {},
       measureCube},
      {"surface_sheet",
       "surface of a thin sheet of liquid on its way over periodic sides; exact sheet",
       nullptr,
       {},
       {},
       {},
       measureSheet},
  };
}

}  // namespace thaw::accuracy
