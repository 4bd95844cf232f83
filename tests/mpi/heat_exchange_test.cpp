// SPDX-License-Identifier: Apache-2.0
// Contact conductance, evaporation and mush: the same bits on any number of ranks.
#include <gtest/gtest.h>

#include "tests/support/rebalanced_run.hpp"

using namespace thaw;
using namespace thaw::test;

namespace {

/// Sums over ranks: hashes of all particles, and counts.
struct State {
  std::int64_t particles = 0, evaporated = 0, frozen = 0, mushy = 0, inContact = 0;
};

State stateOf(const World& w, std::int64_t mushy, Reducer& all) {
  State sum;
  sum.mushy = mushy;
  const Continuum& p = w.particles;
  for (std::size_t i = 0; i < p.owned; i++) {
    std::uint64_t h = mixBits(p.id[i] + 1);
    for (int a = 0; a < 3; a++) h = mixed(mixed(h, p.position[i][a]), p.velocity[i][a]);
    h = mixed(mixed(h, p.mass[i]), p.enthalpy[i]);
    sum.particles += static_cast<std::int64_t>(h >> 24);
    sum.inContact += p.contactNormal[i].z != 0;
  }
  sum.evaporated = w.counters.evaporated;
  sum.frozen = w.counters.frozen;
  all.sum({&sum.particles, sizeof sum / sizeof(std::int64_t)});
  return sum;
}

State runOn(MPI_Comm group, const Scene& scene, int steps) {
  std::int64_t mushy = 0;
  return runRebalanced(
      group, scene, steps,
      [&](const World& w) {
        for (std::size_t i = 0; i < w.particles.owned; i++) mushy += w.particles.mushRate[i] > 0;
      },
      [&](const World& w, Reducer& all) { return stateOf(w, mushy, all); });
}

/// A melt that boils away on a cold mould and freezes on it.
Scene boilingMelt() {
  constexpr double dx = 0.02;
  Scene s = emptyScene(dx, {-0.2, -0.2, 0}, {0.2, 0.2, 0.4});
  s.domain.side[2] = {Side::Wall, Side::Open};
  s.domain.gravity = {0, 0, -9.81};
  s.materials.resize(2);
  Material& metal = s.materials[0];
  metal = wax();
  metal.name = "metal";
  metal.surfaceTension = 1;
  metal.viscosity = {0.5, 0.5};
  metal.soundSpeed = 15;
  metal.hysteresis = 0.3;
  metal.conductivity = {2e4, 2e4};
  metal.contactConductance = 1e6;
  metal.evaporation = {{320, 0}, {345, 20000}};
  metal.evaporationHeat = 1e4;
  metal.mushDrag = 1e5;
  Material& mould = s.materials[1];
  mould.name = "mould";
  mould.young = {8e4, 0};
  mould.conductivity = {2e4, 2e4};
  mould.contactConductance = 5e5;
  Body& base = addBox(s, {-0.14, -0.14, 0}, {0.14, 0.14, 0.06});
  base.material = 1;
  base.temperature = 200;
  Body& melt = addBox(s, {-0.08, -0.08, 0.06}, {0.08, 0.08, 0.2});
  melt.temperature = 350;
  melt.velocity = {0.5, 0.2, 0};
  s.end = 1;
  return s;
}

TEST(HeatExchange, HasTheSameBitsOnAnyNumberOfRanks) {
  for (const DensityForm density : {DensityForm::Summation, DensityForm::Continuity}) {
    Scene scene = boilingMelt();
    scene.numerics.density = density;
    const State alone = runOn(MPI_COMM_SELF, scene, 120), together = runOn(MPI_COMM_WORLD, scene, 120);
    EXPECT_GT(alone.evaporated, 0);
    EXPECT_GT(alone.frozen, 0);
    EXPECT_GT(alone.mushy, 0);
    EXPECT_GT(alone.inContact, 0);
    EXPECT_EQ(alone.evaporated, together.evaporated);
    EXPECT_EQ(alone.mushy, together.mushy);
    EXPECT_EQ(alone.particles, together.particles);
  }
}

}  // namespace
