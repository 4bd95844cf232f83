// SPDX-License-Identifier: Apache-2.0
// Rigid pieces break in impacts (core/rigid/breaking/): stress of bars against beam theory, where a bar
// breaks, and the ledger.
#include <gtest/gtest.h>

#include "core/rigid/breaking/elastic_solve.hpp"
#include "core/simulation/views/views.hpp"
#include "tests/support/rigid/scenes.hpp"

using namespace thaw;
using namespace thaw::test;

namespace {

constexpr double spacing = 0.05;

Material glass(double strength) {
  Material m = stone(2500);
  m.name = "glass";
  m.strength = strength;
  m.impactModulus = 70e9;
  m.restitution = 0.2;
  return m;
}

/// A bar of `along` x `across` x `across` particles along x, in free space.
Scene bar(int along, int across) {
  return freeBox(glass(1e30), spacing, {along * spacing, across * spacing, across * spacing});
}

/// Adds a contact force (N) on the particle nearest to a point of the bar.
void addLoad(const World& w, const Vec3d& at, const Vec3d& force, ImpactLoads& loads) {
  const Continuum& p = w.particles;
  std::size_t nearest = 0;
  for (std::size_t i = 0; i < p.owned; i++)
    if (length(p.position[i] - at) < length(p.position[nearest] - at)) nearest = i;
  loads.records.words.insert(loads.records.words.end(), {p.piece[nearest], p.id[nearest], 0});
  addPlace(loads.records.words, force);
  addPlace(loads.records.words, cross(at - w.pieces.centre[0], force));
}

struct Solved {
  BondedPieces bonded;
  BondedMotion motion;
  /// Returns the stress (Pa) of the particle nearest to a point.
  Sym3d at(const World& w, const Vec3d& x) const {
    std::size_t nearest = 0;
    const Continuum& p = w.particles;
    for (std::size_t m = 0; m < bonded.member.size(); m++)
      if (length(p.position[bonded.member[m]] - x) < length(p.position[bonded.member[nearest]] - x))
        nearest = m;
    return stressOf(bonded, nearest, bonded.member[nearest], motion);
  }
};

void solve(Simulation& sim, const ImpactLoads& loads, Solved& s) {
  const RigidView v = rigidView(sim.w, sim.tools.rigid);
  const std::uint32_t rows[] = {0};
  s.bonded = bondPieces(v, rows);
  solveBonds(v, sim.halos(), s.bonded, balancedLoads(v, s.bonded, loads), s.motion);
}

TEST(RigidBreaking, ABarHitInTheMiddleBendsLikeABeam) {
  for (const int across : {1, 3, 5}) {
    const int along = 41;
    Simulation sim(bar(along, across));
    const double length = along * spacing, height = across * spacing, force = 1000;
    ImpactLoads loads;
    for (int k = 0; k < across; k++)  // over the width, from below
      addLoad(sim.w, {0, (k - (across - 1) / 2.0) * spacing, -height / 2}, {0, 0, force / across}, loads);
    Solved s;
    solve(sim, loads, s);
    // A uniform beam in free flight: F L / 8 in the middle, F x^2 / (2 L) at a distance x from an end.
    for (const int k : {6, 10}) {  // particles from the middle
      const double x = k * spacing, fromEnd = 0.5 * length - x,
                   moment = force * fromEnd * fromEnd / (2 * length),
                   exact = 6 * moment / (height * height * height);
      const double top = s.at(sim.w, {x, 0, (height - spacing) / 2}).xx;
      EXPECT_NEAR(top, exact, 0.05 * exact) << across << " wide, " << k << " from the middle";
    }
  }
}

TEST(RigidBreaking, ARodHitAtItsEndIsCompressedAlongItsLength) {
  Simulation sim(bar(20, 3));
  ImpactLoads loads;
  const double force = 900, area = 9 * spacing * spacing;
  for (int y = -1; y <= 1; y++)
    for (int z = -1; z <= 1; z++)
      addLoad(sim.w, {-10 * spacing, y * spacing, z * spacing}, {force / 9, 0, 0}, loads);
  Solved s;
  solve(sim, loads, s);
  for (const double x : {-5.5, 0.5, 4.5}) {  // spacings from the middle
    const double exact = -force / area * (10 - x) / 20;
    EXPECT_NEAR(s.at(sim.w, {x * spacing, 0, 0}).xx, exact, 0.01 * force / area);
  }
}

/// A bar that falls flat on a ridge below its middle.
Scene barOnRidge(double strength, double speed) {
  Scene s = emptyScene(spacing, {-1.5, -0.5, -1}, {1.5, 0.5, 1});
  s.domain.gravity = {0, 0, -9.81};
  s.materials.push_back(glass(strength));
  addBox(s, {-1, -0.1, 0.02}, {1, 0.1, 0.22}).velocity = {0, 0, -speed};
  s.obstacles.emplace_back();
  s.obstacles.back().name = "ridge";
  s.obstacles.back().shape = boxOf({-0.1, -0.5, -0.3}, {0.1, 0.5, 0});
  s.obstacles.back().restitution = 0.2;
  s.numerics.maxStep = 1e-3;
  s.end = 0.1;
  return s;
}

TEST(RigidBreaking, ABarBreaksOverARidgeIfTheImpactIsHard) {
  constexpr double strength = 60e6;
  for (const double speed : {0.05, 5.0}) {
    Simulation sim(barOnRidge(strength, speed));
    ASSERT_EQ(sim.w.pieces.owned, 1u);
    const double mass = sim.w.pieces.mass[0];
    for (int k = 0; k < 20; k++) ASSERT_TRUE(sim.step());
    if (speed < 1) {
      EXPECT_EQ(sim.w.pieces.owned, 1u);
      EXPECT_EQ(sim.w.counters.brokenPieces, 0);
      continue;
    }
    EXPECT_GE(sim.w.pieces.owned, 2u);
    EXPECT_GT(sim.w.counters.brokenPieces, 0);
    double total = 0;
    for (std::size_t k = 0; k < sim.w.pieces.owned; k++) total += sim.w.pieces.mass[k];
    EXPECT_NEAR(total, mass, 1e-9 * mass);
    const LedgerReport now = sim.ledgerReport();
    EXPECT_LT(length(now.momentumResidual), 1e-9 * mass);
    EXPECT_LT(std::abs(now.energyResidual), 1e-3 * now.energyScale);
    EXPECT_GE(now.dissipated, 0);
  }
}

TEST(RigidBreaking, NumberOfPartsHardlyDependsOnTheStep) {
  std::vector<std::size_t> pieces;
  for (const double step : {2e-3, 2e-4}) {
    Scene s = barOnRidge(60e6, 5);
    s.numerics.maxStep = step;
    Simulation sim(s);
    while (sim.w.clock.time < 0.008) ASSERT_TRUE(sim.step());
    pieces.push_back(sim.w.pieces.owned);
  }
  EXPECT_GE(pieces[0], 2u);
  EXPECT_NEAR(static_cast<double>(pieces[0]), static_cast<double>(pieces[1]), 2);
}

TEST(RigidBreaking, PiecesWithoutStrengthDoNotBreak) {
  Scene s = barOnRidge(never, 5);
  s.materials[0].impactModulus = 0;
  Simulation sim(s);
  EXPECT_FALSE(sim.w.modules.breaking);
  for (int k = 0; k < 20; k++) ASSERT_TRUE(sim.step());
  EXPECT_EQ(sim.w.pieces.owned, 1u);
}

TEST(RigidBreaking, PiecesAtRestDoNotBreak) {
  Scene s = emptyScene(spacing, {-1, -1, -0.5}, {1, 1, 2});
  s.domain.gravity = {0, 0, -9.81};
  addFloor(s);
  s.materials.push_back(glass(1e4));  // below the stress of an impact at 1 cm/s
  for (int k = 0; k < 3; k++) addBox(s, {-0.2, -0.2, 0.2 * k}, {0.2, 0.2, 0.2 * (k + 1)});
  s.numerics.maxStep = 1e-3;
  s.end = 0.5;
  Simulation sim(s);
  ASSERT_TRUE(sim.run());
  EXPECT_EQ(sim.w.pieces.owned, 3u);
}

}  // namespace
