// SPDX-License-Identifier: Apache-2.0
// A world with manually placed particle copies and surfels, for tests of components and measures. Every rank
// creates all of them and keeps its share.
#pragma once
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/halo/serial.hpp"
#include "core/simulation/setup/make_grid.hpp"
#include "core/simulation/setup/prepare_surface.hpp"
#include "core/simulation/views/views.hpp"
#include "core/surface/update_components.hpp"
#include "core/surface/update_surface.hpp"

namespace thaw::test {

struct SurfaceRig {
  World world;
  SurfaceTools tools;
  double dx, d;  // m, spacings of particles and surfels
  int rank = 0, ranks = 1;
  std::uint64_t particles = 0, surfels = 0;  // numbers over all ranks
  std::uint16_t body = 0;
  bool liquid = true;

  explicit SurfaceRig(double spacing = 0.1, const Vec3d& low = {-2, -2, -2}, const Vec3d& high = {2, 2, 2},
                      double surfelSpacing = 0)
      : dx(spacing), d(surfelSpacing > 0 ? surfelSpacing : 0.5 * spacing) {
    world.scene.spacing = dx;
    world.scene.surface.on = true;
    world.scene.surface.spacing = d;
    world.scene.domain.min = low;
    world.scene.domain.max = high;
    world.grid = makeGrid(world.scene.domain, 2 * dx);
    prepareSurface(world);
    Modules m;
    m.fluid = true;
    activateSurfaceFields(world.surface, m, false);
    world.surface.lastStep = 0;  // not the first update
  }
  Surfels& f() { return world.surface.surfels; }
  SurfaceParticles& p() { return world.surface.particles; }

  void particle(const Vec3d& x, std::uint64_t component = noComponent) {
    const std::uint64_t id = particles++;
    if (static_cast<int>(id % static_cast<std::uint64_t>(ranks)) != rank) return;
    const std::size_t i = p().owned;
    p().resize(i + 1, 0);
    p().id[i] = id;
    p().position[i] = x;
    p().volume[i] = dx * dx * dx;
    p().mass[i] = 1000 * p().volume[i];
    p().volumeRatio[i] = 1;
    p().component[i] = component;
    p().liquid[i] = liquid;
    p().body[i] = body;
  }
  void surfel(const Vec3d& x, const Vec3d& n, std::uint64_t component = noComponent) {
    const std::uint64_t id = std::uint64_t{1} << 63 | std::uint64_t{body} << 40 | surfels++;
    if (static_cast<int>(id * 7 % static_cast<std::uint64_t>(ranks)) != rank) return;
    const std::size_t i = f().owned;
    f().resize(i + 1, 0);
    f().id[i] = id;
    f().position[i] = x;
    f().normal[i] = n;
    f().tangent[i] = normalized(cross(n, std::abs(n.x) < 0.6 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0}));
    f().radius[i] = d;
    f().component[i] = component;
    f().liquid[i] = liquid;
  }
  /// Adds a ball: particles of a lattice inside, surfels on a spiral.
  void ball(const Vec3d& c, double R, std::uint64_t component = noComponent) {
    const int n = static_cast<int>(R / dx) + 1;
    for (int z = -n; z <= n; z++)
      for (int y = -n; y <= n; y++)
        for (int x = -n; x <= n; x++) {
          const Vec3d r{(x + 0.5) * dx, (y + 0.5) * dx, (z + 0.5) * dx};
          if (length(r) < R) particle(c + r, component);
        }
    sphere(c, R, component);
  }
  void sphere(const Vec3d& c, double R, std::uint64_t component = noComponent) {
    const int N = static_cast<int>(4 * std::numbers::pi * R * R / (0.8 * d * d));
    for (int k = 0; k < N; k++) {
      const double z = 1 - (2 * k + 1.0) / N, r = std::sqrt(1 - z * z), a = 2.39996322972865332 * k;
      const Vec3d n{r * std::cos(a), r * std::sin(a), z};
      surfel(c + R * n, n, component);
    }
  }
  /// Adds a box of whole spacings: a lattice inside, surfels at the centres of squares on the faces.
  void box(const Vec3d& low, const Vec3i& cells, std::uint64_t component = noComponent) {
    for (int z = 0; z < cells.z; z++)
      for (int y = 0; y < cells.y; y++)
        for (int x = 0; x < cells.x; x++) particle(low + dx * Vec3d{x + 0.5, y + 0.5, z + 0.5}, component);
    for (int a = 0; a < 3; a++) {
      const int b = (a + 1) % 3, e = (a + 2) % 3;
      for (int side = 0; side < 2; side++)
        for (int j = 0; j < 2 * cells[b]; j++)
          for (int k = 0; k < 2 * cells[e]; k++) {
            Vec3d x = low, n{};
            x[a] += side * cells[a] * dx;
            x[b] += (j + 0.5) * d;
            x[e] += (k + 0.5) * d;
            n[a] = side ? 1 : -1;
            surfel(x, n, component);
          }
    }
  }
  /// The component of each particle id; ~0 for particles of other ranks.
  std::vector<std::uint64_t> labels() {
    std::vector<std::uint64_t> l(particles, ~std::uint64_t{0});
    for (std::size_t i = 0; i < p().owned; i++) l[p().id[i]] = p().component[i];
    return l;
  }
  void update(SurfaceHalos halos) { updateComponents(surfaceView(world), halos, tools); }
  const std::vector<SurfaceComponent>& components() const { return world.surface.components; }
};

struct SerialSurfaceRig : SurfaceRig {
  SerialSurfaceRanks halos;
  explicit SerialSurfaceRig(double spacing = 0.1, const Vec3d& low = {-2, -2, -2},
                            const Vec3d& high = {2, 2, 2}, double surfelSpacing = 0)
      : SurfaceRig(spacing, low, high, surfelSpacing), halos(world.surface.grid) {}
  void update() { SurfaceRig::update(halos.halos()); }
};

}  // namespace thaw::test
