// SPDX-License-Identifier: Apache-2.0
// Liquids and solids in one scene: a liquid rests on a solid, and a solid falls into a liquid.
#include <gtest/gtest.h>

#include <cmath>

#include "core/fluid/laws/particle_pressure.hpp"
#include "core/walls/walls.hpp"
#include "tests/support/simulation.hpp"

namespace thaw::test {
namespace {

/// A tank of water, with soft rubber as the second material.
Scene poolAndRubber() {
  Scene s = columnScene(0.01, 0, 0.3);
  s.domain.max = {0.12, 0.12, 0.3};
  s.domain.side[2] = {Side::Wall, Side::Open};
  s.domain.gravity = {0, 0, -9.81};
  s.materials.emplace_back();
  s.materials[0].density = 1000;
  s.materials[0].viscosity = {1, 1};
  s.materials[0].soundSpeed = 20;
  s.materials[1].name = "rubber";
  s.materials[1].density = 1000;
  s.materials[1].young = {3e5, 3e5};
  s.materials[1].law.name = "neo-hookean";
  return s;
}

}  // namespace

/// Smallest distance (m) between a liquid and a solid particle.
double closest(const Continuum& p) {
  double least = 1;
  for (std::size_t i = 0; i < p.owned; i++)
    for (std::size_t j = 0; j < p.owned && p.phase[i] == Liquid; j++)
      if (p.phase[j] == Solid) least = std::min(least, length(p.position[i] - p.position[j]));
  return least;
}

// The pressure between a liquid and a solid derives from the liquid's energy, so energy is conserved.
TEST(Mixed, SolidFallsIntoALiquid) {
  Scene s = poolAndRubber();
  addBox(s, {0, 0, 0}, {0.12, 0.12, 0.08});
  Body& b = addBox(s, {0.03, 0.03, 0.09}, {0.09, 0.09, 0.13});
  b.material = 1;
  b.velocity = {0, 0, -1};
  s.numerics.cflSound = 0.2;  // the energy lost by drag in an impact has an error of first order
  s.end = 0.3;
  Simulation run(s);
  double least = 1;
  while (run.w.clock.time < s.end) {
    ASSERT_TRUE(run.step());
    if (run.w.clock.step % 50 == 0) least = std::min(least, closest(run.particles()));
  }
  const LedgerReport r = run.ledgerReport();
  EXPECT_LT(std::abs(r.energyResidual), 0.005 * r.energyScale);
  EXPECT_LT(length(r.momentumResidual), 1e-6 * length(r.gravityImpulse));
  EXPECT_GT(least, 0.5 * s.spacing);  // no liquid enters the solid
}

// A liquid on a solid bottom. Layers of an undisturbed lattice carry pressure unevenly (the lowest layer
// twice its part). Only the means of adjacent layers are hydrostatic, so the first and the last layer count
// by half.
TEST(Mixed, LiquidRestsOnASolid) {
  Scene s = poolAndRubber();
  s.domain.max = {0.06, 0.06, 0.3};
  addBox(s, {0, 0, 0}, {0.06, 0.06, 0.05}).material = 1;
  addBox(s, {0, 0, 0.05}, {0.06, 0.06, 0.2});
  s.materials[0].viscosity = {200, 200};  // damps sound
  s.end = 0.5;
  Simulation run(s);
  ASSERT_TRUE(run.run());
  const Continuum& p = run.particles();
  double pressure = 0, exact = 0, bottom = 1, solidTop = 0, top = 0;
  // the liquid sinks slightly, since rubber and liquid are compressed
  for (std::size_t i = 0; i < p.owned; i++) top = std::max(top, p.position[i].z + 0.5 * s.spacing);
  for (std::size_t i = 0; i < p.owned; i++) {
    const double z = p.position[i].z;
    if (p.phase[i] == Solid) {
      solidTop = std::max(solidTop, z);
      continue;
    }
    bottom = std::min(bottom, z);
    if (z < 0.08 || z > 0.17) continue;
    const double weight = z < 0.09 || z > 0.16 ? 0.5 : 1;
    pressure += weight * static_cast<double>(pressureOfParticle(run.w.scene, run.w.modules, run.w.particles,
                                                                run.tools.liquids, i));
    exact += weight * 1000 * 9.81 * (top - z);
  }
  EXPECT_NEAR(pressure, exact, 0.02 * exact);
  EXPECT_GT(closest(p), 0.9 * s.spacing);
  EXPECT_LT(bottom - solidTop, 1.1 * s.spacing);
}

}  // namespace thaw::test
