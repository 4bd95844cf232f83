// SPDX-License-Identifier: Apache-2.0
// A surface without particles and without MPI, for tests.
#pragma once
#include <array>
#include <cmath>
#include <functional>
#include <vector>

#include "core/halo/serial.hpp"
#include "core/math/hash_random.hpp"
#include "core/math/tangent.hpp"
#include "core/simulation/setup/prepare_surface.hpp"
#include "core/simulation/views/views.hpp"
#include "core/surface/data/place_rows.hpp"
#include "core/surface/resampling/births.hpp"
#include "core/surface/resampling/resample.hpp"
#include "core/surface/seeding/sample_mesh.hpp"
#include "core/surface/update_surface.hpp"
#include "tests/support/meshes.hpp"

namespace thaw::test {

inline Scene surfelScene(double spacing) {
  Scene s;
  s.spacing = 2 * spacing;
  s.domain.min = {-3, -3, -3};
  s.domain.max = {3, 3, 3};
  s.surface.on = true;
  s.surface.spacing = spacing;
  return s;
}

struct SurfelRig {
  World world;
  SurfaceTools tools;
  std::unique_ptr<SerialSurfaceRanks> ranks;

  explicit SurfelRig(Scene scene) {
    world.scene = std::move(scene);
    world.grid.support = 2 * world.scene.spacing;
    prepareSurface(world);
    Modules m;
    m.fluid = true;
    activateSurfaceFields(world.surface, m, false);
    ranks = std::make_unique<SerialSurfaceRanks>(world.surface.grid);
  }
  Surfels& surfels() { return world.surface.surfels; }
  void add(const Vec3d& x, const Vec3d& n, std::uint64_t component = 1) {
    SurfelRow r;
    r.id = surfelBit | next++;
    r.position = x;
    r.normal = n;
    r.tangent = anyTangent(n);
    r.component = component;
    r.radius = world.surface.spacing;
    appendSurfels(surfels(), {r});
  }
  Resampled resample(std::int64_t rounds) {  // the test moves surfels directly, so all are checked
    std::fill_n(surfels().resampleMargin.data(), surfels().owned, 0.0f);
    return thaw::resample(surfaceView(world), ranks->halos(), tools, rounds);
  }

  /// Largest distance, over the spacing, from points of the exact surface to the nearest surfel on the same
  /// side.
  double largestHole(const std::vector<SurfacePoint>& truth) {
    Surfels& s = surfels();
    double hole = 0;
    for (const SurfacePoint& p : truth) {
      double best = 1e300;
      for (std::size_t i = 0; i < s.owned; i++)
        if (dot(s.normal[i], p.normal) > oneSide)
          best = std::min(best, dot(s.position[i] - p.position, s.position[i] - p.position));
      hole = std::max(hole, std::sqrt(best) / world.surface.spacing);
    }
    return hole;
  }
  std::uint64_t next = 1;
};

/// n points on a ball's surface, along a spiral.
inline std::vector<SurfacePoint> spherePoints(std::size_t n, double radius) {
  std::vector<SurfacePoint> p;
  for (std::size_t k = 0; k < n; k++) {
    const double z = 1 - 2 * (static_cast<double>(k) + 0.5) / static_cast<double>(n),
                 r = std::sqrt(1 - z * z), a = 2.399963229728653 * static_cast<double>(k);
    const Vec3d u{r * std::cos(a), r * std::sin(a), z};
    p.push_back({radius * u, u});
  }
  return p;
}

}  // namespace thaw::test
