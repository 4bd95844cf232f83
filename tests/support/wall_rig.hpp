// SPDX-License-Identifier: Apache-2.0
// Particles and walls without neighbours: the wall part of a step alone.
#pragma once
#include <functional>

#include "core/neighbours/sort.hpp"
#include "core/simulation/setup/make_grid.hpp"
#include "core/simulation/time/integrate.hpp"
#include "core/simulation/views/views.hpp"
#include "core/walls/wall_forces.hpp"

namespace thaw::test {

/// A half-space below z = 0 in its own frame.
struct Ground : SignedDistance {
  double distance(const Vec3d& x, Vec3d* n) const override {
    if (n) *n = {0, 0, 1};
    return x.z;
  }
  Bounds bounds() const override { return {{-never, -never, -never}, {never, never, 0}}; }
};

struct WallRig {
  World w;
  WallTables tables;
  std::vector<LiquidMaterial> liquids;
  WallContacts contacts;
  SortBuffers sort;
  double firstStep = 1e-3;  // s

  WallRig() {
    Scene& s = w.scene;
    s.spacing = 0.1;
    s.domain.min = {-2, -2, -2};
    s.domain.max = {2, 2, 2};
    Material m;
    m.young = {1e5, 1e5};
    m.restitution = 1;
    m.soundSpeed = 10;
    s.materials.push_back(m);
    s.bodies.emplace_back();
    for (AnyColumn* c : w.particles.columns)
      if (c != &w.particles.shiftingVelocity && c != &w.particles.clamped && c != &w.particles.drag &&
          c != &w.particles.restDensity)
        w.particles.activate(*c);
  }

  /// Adds a wall with this surface and returns its properties.
  Obstacle& add(std::shared_ptr<const SignedDistance> shape) {
    Wall wall;
    wall.bounds = shape->bounds();
    wall.shape = std::move(shape);
    wall.properties.restitution = 1;
    w.walls.list.push_back(std::move(wall));
    return w.walls.list.back().properties;
  }

  void addParticle(const Vec3d& x, const Vec3d& v, Phase phase = Solid) {
    Continuum& p = w.particles;
    const std::size_t i = p.owned;
    p.resize(i + 1, 0);
    p.id[i] = i;
    p.position[i] = x;
    p.velocity[i] = v;
    p.mass[i] = w.scene.materials[0].density * w.scene.spacing * w.scene.spacing * w.scene.spacing;
    p.phase[i] = phase;
    p.liquid[i] = phase == Liquid;
    p.relativeDensity[i] = 1;
    p.solidIndex[i] = noSolid;
    p.temperature[i] = 300;
    p.contactOffset[i] = 0.5f;
  }

  void start() {
    w.grid = makeGrid(w.scene);
    tables = makeWallTables(w.scene.numerics);
    liquids = liquidMaterials(w.scene);
    evaluate(0);
    for (std::size_t i = 0; i < w.particles.owned; i++)
      w.particles.acceleration[i] = w.particles.force[i] / w.particles.mass[i] + w.scene.domain.gravity;
  }

  void evaluate(double dt) {
    Continuum& p = w.particles;
    computeCellKeys(w.grid, p);
    Migration all;
    all.arrivals = p.owned;
    sortByCell(p, all, sort, w.cells);
    for (std::size_t i = 0; i < p.owned; i++)
      p.force[i] = {}, p.dissipation[i] = p.interaction[i] = p.heatFlow[i] = 0;
    const WallContext x{wallView(w), tables, liquids, dt, dt > 0 ? dt : firstStep};
    findWallContacts(x, contacts);
    recordProjections(x, contacts);
    addWallForces(x, 1, contacts);
  }

  void step(double dt) {
    for (std::size_t i = 0; i < w.particles.owned && w.clock.step == 0; i++)
      w.particles.dissipated[i] += w.particles.dissipation[i] * 0.5 * dt;
    const RowSpan all[1] = {{0, static_cast<std::uint32_t>(w.particles.owned)}};
    kickAndDrift(w, dt, all);
    moveWalls(w.walls, w.clock.time + dt);
    evaluate(dt);
    std::size_t bad = 0;
    LargestRates largest;
    finishKick(w, dt, all, &bad, &largest);
    w.clock.time += dt;
    w.clock.step++;
  }

  /// Kinetic, potential and contact energy (J).
  double mechanical() const {
    const Continuum& p = w.particles;
    double e = 0;
    for (std::size_t i = 0; i < p.owned; i++)
      e += 0.5 * p.mass[i] * dot(p.velocity[i], p.velocity[i]) -
           p.mass[i] * dot(w.scene.domain.gravity, p.position[i]) + p.interaction[i];
    return e;
  }
  double dissipated() const {
    double e = 0;
    for (std::size_t i = 0; i < w.particles.owned; i++) e += w.particles.dissipated[i];
    return e;
  }
};

}  // namespace thaw::test
