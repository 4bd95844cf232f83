// SPDX-License-Identifier: Apache-2.0
// Bodies of lattice particles with surfels in one process, for tests and benchmarks of the surface.
#pragma once
#include <functional>
#include <map>
#include <memory>
#include <numbers>

#include "core/halo/serial.hpp"
#include "core/math/hash_random.hpp"
#include "core/simulation/setup/make_grid.hpp"
#include "core/simulation/setup/prepare_surface.hpp"
#include "core/simulation/views/views.hpp"
#include "core/surface/data/place_rows.hpp"
#include "core/surface/relaxation/relax.hpp"
#include "core/surface/update_surface.hpp"

namespace thaw::test {

/// A world with the data that a surface update reads: spacing dx = 1, particle copies (component 1, liquid
/// 1), surfels.
struct RelaxRig {
  World w;
  std::unique_ptr<SerialSurfaceRanks> ranks;
  SurfaceTools tools;

  explicit RelaxRig(double surfelSpacing = 0.5, double half = 24,
                    const std::function<void(Scene&)>& change = {}) {
    w.scene.spacing = 1;
    w.scene.domain.min = {-half, -half, -half};
    w.scene.domain.max = {half, half, half};
    w.scene.surface.on = true;
    w.scene.surface.spacing = surfelSpacing;
    if (change) change(w.scene);
    w.grid = makeGrid(w.scene);
    prepareSurface(w);
    Modules m;
    m.fluid = true;
    activateSurfaceFields(w.surface, m, false);
    ranks = std::make_unique<SerialSurfaceRanks>(w.surface.grid);
  }
  void addParticle(const Vec3d& x, const Vec3d& u = {}, std::uint64_t component = 1, float liquid = 1) {
    SurfaceParticles& p = w.surface.particles;
    const std::size_t i = p.owned;
    p.resize(i + 1, 0);
    p.id[i] = i;
    p.position[i] = x;
    p.displacement[i] = u;
    p.component[i] = component;
    p.volume[i] = 1;
    p.liquid[i] = liquid;
    p.source[i] = i;
  }
  void addSurfel(const Vec3d& x, const Vec3d& n, std::uint64_t component = 1, float liquid = 1) {
    Surfels& s = w.surface.surfels;
    const std::size_t i = s.owned;
    s.resize(i + 1, 0);
    s.id[i] = 1000 + i;
    s.position[i] = x;
    s.normal[i] = normalized(n);
    s.tangent[i] = normalized(
        cross(s.normal[i], std::abs(s.normal[i].x) < 0.6 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0}));
    s.radius[i] = w.surface.spacing;
    s.component[i] = component;
    s.detail[i] = 1;
    s.liquid[i] = liquid;
  }
  /// Adds particles of the cubic lattice at (k + shift) inside a shape.
  void addLattice(int half, const Vec3d& shift, const std::function<bool(const Vec3d&)>& inside) {
    for (int z = -half; z <= half; z++)
      for (int y = -half; y <= half; y++)
        for (int x = -half; x <= half; x++)
          if (const Vec3d p = Vec3d{double(x), double(y), double(z)} + shift; inside(p)) addParticle(p);
  }
  /// Adds surfels on a ball in a spiral, about one per spacing^2 cos 30 degrees, displaced by up to `noise`.
  void addBallSurfels(double radius, double noise = 0, std::uint64_t component = 1) {
    const double pi = std::numbers::pi, d = w.surface.spacing;
    const int n = static_cast<int>(4 * pi * radius * radius / (0.866 * d * d));
    for (int k = 0; k < n; k++) {
      const double z = 1 - (2 * k + 1.0) / n, a = k * pi * (3 - std::sqrt(5.0)), r = std::sqrt(1 - z * z);
      const Vec3d e{r * std::cos(a), r * std::sin(a), z};
      const auto random = [&](std::uint64_t c) {
        return 2 * randomUniform(1, Purpose::Test, static_cast<std::uint64_t>(k), c) - 1;
      };
      addSurfel((radius + noise * random(0)) * e + noise * Vec3d{random(1), random(2), random(3)}, e,
                component);
    }
  }
  void place() {
    placeRows(w.surface.grid, ranks->surfels, w.surface.surfels, w.surface.surfelCells, tools.sort);
    placeRows(w.surface.grid, ranks->particles, w.surface.particles, w.surface.particleCells, tools.sort);
    tools.relax.particlesPrepared = false;
  }
  RelaxationResult relaxSurfels(std::int64_t iterations, bool all = true) {
    return thaw::relaxSurfels(surfaceView(w), ranks->halos(), tools, forceWeights(w.scene.surface),
                              iterations, all);
  }
};

/// Deviations of surfels from a ball around the origin: lengths over its radius, angles in degrees.
struct BallErrors {
  double hausdorff = 0, mean = 0, normalMean = 0, normalMax = 0, volume = 0;
};
inline BallErrors ballErrors(const Surfels& s, double radius) {
  BallErrors e;
  const double n = static_cast<double>(s.owned);
  for (std::size_t i = 0; i < s.owned; i++) {
    const double r = length(s.position[i]),
                 angle = std::acos(std::clamp(dot(s.normal[i], s.position[i]) / r, -1.0, 1.0)) *
                         57.29577951308232;
    e.hausdorff = std::max(e.hausdorff, std::abs(r - radius) / radius);
    e.mean += (r - radius) / radius / n;
    e.normalMean += angle / n;
    e.normalMax = std::max(e.normalMax, angle);
    e.volume += (r * r * r / (radius * radius * radius) - 1) / n;
  }
  return e;
}

/// Places of all surfels by id.
inline std::map<std::uint64_t, Vec3d> places(const Surfels& s) {
  std::map<std::uint64_t, Vec3d> at;
  for (std::size_t i = 0; i < s.owned; i++) at[s.id[i]] = s.position[i];
  return at;
}

/// Adds a ball of radius R spacings with surfels that are off its surface by up to `noise`.
inline void addBall(RelaxRig& rig, double R, double noise = 0.1) {
  rig.addLattice(static_cast<int>(R) + 1, {0.5, 0.5, 0.5}, [&](const Vec3d& x) { return length(x) < R; });
  rig.addBallSurfels(R, noise);
  rig.place();
}

}  // namespace thaw::test
