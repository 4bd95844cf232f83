// SPDX-License-Identifier: Apache-2.0
#include "core/oriented/sampling/sample_surface.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/geometry/meshes/mesh_normals.hpp"
#include "core/geometry/sampling/blue_noise.hpp"
#include "core/geometry/trees/triangle_bvh.hpp"
#include "core/math/hash_random.hpp"
#include "core/oriented/sampling/poisson_discs.hpp"
#include "core/oriented/sampling/relax_points.hpp"

namespace thaw {
namespace {

// Maximum number of lattice points along an axis, since bins of samples have 21 bits (poisson_discs.cpp).
constexpr int mostAlong = 1 << 20;

Vec3i latticeOf(const Vec3d& size, double fine) {
  Vec3i count;
  for (int a = 0; a < 3; a++) {
    const double points = std::ceil(size[a] / fine) + 3;
    if (!(points < mostAlong))
      throw std::invalid_argument(
          "its spacing is too small for its size; expected at most 300000 spacings along each axis");
    count[a] = static_cast<int>(points);
  }
  return count;
}

/// Calls use(i, j, k) for the lattice points in [low, high) that may lie within `fine` (m) of the surface.
/// Blocks are halved until the distance of their centre excludes them.
template<class At, class Use>
void eachNearSurface(const SignedDistance& shape, double fine, const Vec3i& low, const Vec3i& high,
                     const At& at, const Use& use) {
  const Vec3i size{high.x - low.x, high.y - low.y, high.z - low.z};
  const int longest = std::max({size.x, size.y, size.z});
  if (longest > 4) {
    const Vec3d a = at(low.x, low.y, low.z), b = at(high.x - 1, high.y - 1, high.z - 1);
    const double reach = 0.5 * length(b - a) * (1 + 1e-9) + fine;
    if (std::abs(shape.distanceWithin(0.5 * (a + b), reach)) >= reach) return;
    Vec3i middleHigh = high, middleLow = low;
    const int axis = size.x == longest ? 0 : size.y == longest ? 1 : 2;
    middleHigh[axis] = middleLow[axis] = low[axis] + longest / 2;
    eachNearSurface(shape, fine, low, middleHigh, at, use);
    eachNearSurface(shape, fine, middleLow, high, at, use);
    return;
  }
  for (int k = low.z; k < high.z; k++)
    for (int j = low.y; j < high.y; j++)
      for (int i = low.x; i < high.x; i++) use(i, j, k);
}

}  // namespace

SampledPoints sampleSurface(const SignedDistance& shape, double spacing, std::uint64_t seed) {
  const double fine = spacing / 3, apart = 0.75 * spacing;
  const Bounds box = shape.bounds();
  const Vec3d size = box.max - box.min;
  if (!std::isfinite(size.x + size.y + size.z))
    throw std::invalid_argument(
        "an infinite surface cannot be sampled with particles; expected a bounded shape");
  const Vec3i count = latticeOf(size, fine);
  std::vector<SurfaceSample> samples;
  const auto at = [&](int i, int j, int k) {
    return box.min + Vec3d{(i - 1) * fine, (j - 1) * fine, (k - 1) * fine};
  };
  eachNearSurface(shape, fine, {0, 0, 0}, count, at, [&](int i, int j, int k) {
    Vec3d x = at(i, j, k), n;
    double d = shape.distanceWithin(x, fine, &n);
    if (std::abs(d) >= fine) return;
    for (int pass = 0; pass < 4; pass++) {
      x -= d * n;
      d = shape.distanceWithin(x, fine, &n);
    }
    if (std::abs(d) > 0.05 * spacing) return;
    const std::uint64_t number = (static_cast<std::uint64_t>(k) * static_cast<std::uint64_t>(count.y) +
                                  static_cast<std::uint64_t>(j)) *
                                     static_cast<std::uint64_t>(count.x) +
                                 static_cast<std::uint64_t>(i);
    samples.push_back({randomBits(seed, Purpose::OrientedSample, number), x, n});
  });
  SampledPoints m;
  addPoissonDiscs(samples, apart, m);
  relaxPoints(1.05 * spacing, m, [&](Vec3d& place, Vec3d& n) {
    const double d = shape.distanceWithin(place, spacing, &n);
    place -= d * n;
  });
  return m;
}

SampledPoints sampleOpenMesh(const TriangleMesh& mesh, double spacing, std::uint64_t seed) {
  const MeshNormals normals(mesh);
  const TriangleBvh tree(mesh);
  SampledPoints m;
  for (const MeshSample& s : blueNoise(mesh, spacing, seed))
    addPoint(m, s.position, normals.at(s.position, s.triangle));
  relaxPoints(1.05 * spacing, m, [&](Vec3d& place, Vec3d& n) {
    const ClosestPoint there = tree.closest(place);
    place = there.point;
    n = normals.at(place, there.triangle);
  });
  return m;
}

}  // namespace thaw
