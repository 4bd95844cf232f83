// SPDX-License-Identifier: Apache-2.0
// A whole scene on one rank, stepped as in a run, for tests of exact solutions and the ledger.
#pragma once
#include "core/simulation/ledger/report.hpp"
#include "core/simulation/setup/serial_simulation.hpp"

namespace thaw::test {

struct Simulation : SerialSimulation {
  World& w = world;
  Limit limitedBy = Limit::Scene;
  double shortest = never;  ///< s, smallest dt so far

  SamplingReport report;  ///< report of the start

  explicit Simulation(const Scene& scene, const MeshLoader& load = {}) {
    world.scene = scene;
    prepare(load);
    report = start(load);
  }
  Simulation(const Simulation&) = delete;
  Continuum& particles() { return w.particles; }

  /// Takes one step. Returns false if a value is not finite.
  bool step() {
    const StepOutcome o = SerialSimulation::step();
    limitedBy = o.limitedBy;
    shortest = std::min(shortest, w.clock.stepDt);
    return o.finite;
  }
  /// Runs to the end of the scene.
  bool run() {
    while (w.clock.time < w.clock.end)
      if (!step()) return false;
    return true;
  }
  LedgerReport ledgerReport() { return reportLedger(w, tools, all); }
};

/// The wax of scenes/melt.toml: melts from 313 to 338 K.
inline Material wax() {
  Material m;
  m.density = 900;
  m.young = {3e5, 0};
  m.law.name = "neo-hookean";
  m.damping = 4;
  m.viscosity = {10, 10};
  m.conductivity = {300, 300};
  m.heatCapacity = {2000, 2000};
  m.latentHeat = 3e4;
  m.solidus = 313;
  m.liquidus = 338;
  return m;
}

inline Shape boxOf(const Vec3d& low, const Vec3d& high) {
  Shape s;
  s.size = high - low;
  s.move = 0.5 * (low + high);
  return s;
}

/// An empty scene with open sides, no gravity, no frames.
inline Scene emptyScene(double spacing, const Vec3d& low, const Vec3d& high) {
  Scene s;
  s.spacing = spacing;
  s.domain.min = low;
  s.domain.max = high;
  s.domain.gravity = {};
  s.output.every = 0;
  return s;
}

/// Gives liquids carried densities, negative pressure and shifting, as the defaults for free surfaces.
inline void carryDensity(Scene& s, double shifting) {
  s.numerics.density = DensityForm::Continuity;
  s.numerics.tensileLimit = 1;
  s.numerics.shifting = shifting;
}

/// A scene of one material without gravity, periodic along x and y over six spacings, open along z.
inline Scene columnScene(double spacing, double zLow, double zHigh) {
  Scene s = emptyScene(spacing, {0, 0, zLow}, {6 * spacing, 6 * spacing, zHigh});
  s.domain.side[0] = s.domain.side[1] = {Side::Periodic, Side::Periodic};
  s.materials.emplace_back();
  s.materials[0].name = "stuff";
  return s;
}

inline Body& addBox(Scene& s, const Vec3d& low, const Vec3d& high) {
  s.bodies.emplace_back();
  s.bodies.back().name = "box" + std::to_string(s.bodies.size());
  s.bodies.back().shape = boxOf(low, high);
  return s.bodies.back();
}

/// A floor (half-space) below z = 0.
inline Obstacle& addFloor(Scene& s) {
  s.obstacles.emplace_back();
  s.obstacles.back().name = "floor";
  s.obstacles.back().shape.kind = ShapeKind::HalfSpace;
  return s.obstacles.back();
}

}  // namespace thaw::test
