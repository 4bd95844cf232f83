// SPDX-License-Identifier: Apache-2.0
#include "benchmarks/accuracy/surface/surface_trials.hpp"

#include <mpi.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace thaw::accuracy {

SurfelCloud cloudOf(Trial& r) {
  const Surface& s = r.world.surface;
  std::vector<CloudSurfel> mine(s.surfels.owned);
  for (std::size_t i = 0; i < mine.size(); i++)
    mine[i] = {s.surfels.id[i],     s.surfels.position[i], s.surfels.normal[i],
               s.surfels.radius[i], s.surfels.area[i],     s.surfels.component[i]};
  std::vector<int> bytes(static_cast<std::size_t>(r.comm.size())), first(bytes.size());
  const int own = static_cast<int>(mine.size() * sizeof(CloudSurfel));
  MPI_Allgather(&own, 1, MPI_INT, bytes.data(), 1, MPI_INT, r.comm.handle());
  for (std::size_t k = 1; k < bytes.size(); k++) first[k] = first[k - 1] + bytes[k - 1];
  SurfelCloud c;
  c.surfels.resize(static_cast<std::size_t>(first.back() + bytes.back()) / sizeof(CloudSurfel));
  MPI_Allgatherv(mine.data(), own, MPI_BYTE, c.surfels.data(), bytes.data(), first.data(), MPI_BYTE,
                 r.comm.handle());
  std::sort(c.surfels.begin(), c.surfels.end(),
            [](const CloudSurfel& a, const CloudSurfel& b) { return a.id < b.id; });
  double largest = s.spacing;
  for (const CloudSurfel& f : c.surfels) {
    c.at.push_back(f.position);
    largest = std::max(largest, f.radius);
  }
  c.reach = 4 * largest;
  fillBins(c.at.data(), c.at.size(), c.reach, c.bins);
  return c;
}

double toNearest(const SurfelCloud& c, const Vec3d& x) {
  double least = never;
  forRowsWithin(c.bins, x, c.reach, [&](std::uint32_t, double d2) { least = std::min(least, d2); });
  return std::sqrt(least);
}

double toDiscs(const SurfelCloud& c, const Vec3d& x) {
  double least = never;
  forRowsWithin(c.bins, x, c.reach, [&](std::uint32_t i, double) {
    const CloudSurfel& f = c.surfels[i];
    const Vec3d d = x - f.position;
    const double off = dot(d, f.normal), across = length(d - off * f.normal);
    least = std::min(least, std::hypot(off, std::max(0.0, across - f.radius)));
  });
  return least;
}

double meanNeighbours(const SurfelCloud& c, double radius) {
  double count = 0;
  for (const Vec3d& x : c.at) forRowsWithin(c.bins, x, radius, [&](std::uint32_t, double) { count++; });
  return c.at.empty() ? 0 : count / static_cast<double>(c.at.size()) - 1;
}

FromExact fromExact(const SurfelCloud& c, const std::vector<Vec3d>& points) {
  FromExact f;
  for (const Vec3d& x : points) {
    const double off = toDiscs(c, x), near = toNearest(c, x);
    f.distance = std::max(f.distance, off);
    f.hole = std::max(f.hole, near < never ? std::sqrt(std::max(0.0, near * near - off * off)) : never);
  }
  return f;
}

std::vector<Vec3d> ballPoints(std::size_t n) {
  constexpr double goldenAngle = 2.39996322972865332;
  std::vector<Vec3d> points;
  for (std::size_t k = 0; k < n; k++) {
    const double z = 1 - (2.0 * static_cast<double>(k) + 1) / static_cast<double>(n),
                 across = std::sqrt(1 - z * z), angle = goldenAngle * static_cast<double>(k);
    points.push_back({across * std::cos(angle), across * std::sin(angle), z});
  }
  return points;
}

double degreesBetween(const Vec3d& a, const Vec3d& b) {
  return 180 / std::numbers::pi * std::atan2(length(cross(a, b)), dot(a, b));
}

double surfaceVolume(const World& w) {
  double v = 0;
  for (const SurfaceComponent& c : w.surface.components) v += c.volume;
  return v;
}

double particleVolume(const World& w) {
  double v = 0;
  for (const SurfaceComponent& c : w.surface.components) v += c.particleVolume;
  return v;
}

double surfaceArea(const World& w) {
  double a = 0;
  for (const SurfaceComponent& c : w.surface.components) a += c.area;
  return a;
}

void addCost(Trial& r, const SurfelCloud& c, std::vector<Figure>& figures) {
  const Surface& s = r.world.surface;
  figures.push_back({"surfels", static_cast<double>(c.surfels.size())});
  figures.push_back({"surfel neighbours", meanNeighbours(c, s.surfelSupport)});
  figures.push_back({"iterations an update", static_cast<double>(s.counters.iterations) /
                                                 std::max(1.0, static_cast<double>(s.counters.updates))});
  figures.push_back(
      {"core-us an update and surfel",
       1e6 * r.updateSeconds /
           std::max(1.0, static_cast<double>(s.counters.updates) * static_cast<double>(c.surfels.size()))});
}

}  // namespace thaw::accuracy
