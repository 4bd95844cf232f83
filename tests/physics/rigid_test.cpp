// SPDX-License-Identifier: Apache-2.0
// Motion, melting, freezing and floating of rigid pieces.
#include <gtest/gtest.h>

#include <bit>
#include <numbers>

#include "core/simulation/monitor/snapshot.hpp"
#include "tests/support/rigid/scenes.hpp"

using namespace thaw;
using namespace thaw::test;

namespace {

double spinEnergy(const Pieces& p, std::size_t row) {
  return 0.5 * dot(p.angularMomentum[row], spinOf(p, row, p.angularMomentum[row]));
}

/// Sets the enthalpy (J/kg) of all particles whose number on the lattice along x is `column` of `columns`.
void setColumn(Continuum& p, std::uint64_t columns, std::uint64_t column, double enthalpy) {
  for (std::size_t i = 0; i < p.owned; i++)
    if ((p.id[i] & 0xffffffffff) % columns == column) p.enthalpy[i] = enthalpy;
}

/// A bar of 18 x 4 x 4 particles of wax that turns freely.
Scene turningBar() {
  Scene s = freeBox(rigidWax(), 0.1, {1.8, 0.4, 0.4});
  s.bodies[0].spin = {0.3, 0, 1};
  s.bodies[0].velocity = {0, 0, 0.1};
  s.bodies[0].temperature = 300;
  s.thermostats.emplace_back();
  s.thermostats[0].start = 100;
  s.numerics.maxStep = 2e-3;
  s.end = 10;
  return s;
}

TEST(Rigid, TumblingKeepsEnergyAndAngularMomentum) {
  Scene s = freeBox(stone(), 0.1, {0.6, 0.4, 0.2});
  s.bodies[0].spin = {0.01, 3, 0.02};  // about the middle axis, which is unstable
  s.numerics.fixedStep = 1e-3;
  s.end = 1e3;
  Simulation sim(s);
  const Pieces& p = sim.w.pieces;
  ASSERT_EQ(p.owned, 1u);
  const double energy = spinEnergy(p, 0);
  const Vec3d momentum = p.angularMomentum[0];
  double turned = 1;  // cosine between the middle axis and its start
  const Vec3d axis = rotated(p.orientation[0], {0, 1, 0});
  for (int k = 0; k < 100000; k++) {
    ASSERT_TRUE(sim.step());
    turned = std::min(turned, dot(axis, rotated(p.orientation[0], {0, 1, 0})));
  }
  EXPECT_LT(turned, -0.9) << "it never turned over";
  EXPECT_NEAR(spinEnergy(p, 0), energy, 1e-10 * energy);
  EXPECT_LT(length(p.angularMomentum[0] - momentum), 1e-10 * length(momentum));
  EXPECT_NEAR(sim.ledgerReport().energyResidual, 0, 1e-10 * energy);
}

TEST(Rigid, CubeOfParticlesHasTheInertiaOfTheCube) {
  Simulation sim(freeBox(stone(1000), 0.1, {0.5, 0.5, 0.5}));
  const Pieces& p = sim.w.pieces;
  EXPECT_NEAR(p.mass[0], 125, 1e-9);
  for (int a = 0; a < 3; a++) EXPECT_NEAR(p.inertia[0][a], 125 * 0.25 / 6, 1e-9);
}

TEST(Rigid, ParticlesKeepTheirPlacesInThePiece) {
  Scene s = freeBox(stone(), 0.1, {0.4, 0.3, 0.2});
  s.bodies[0].spin = {1, 2, 3};
  s.domain.gravity = {0, 0, -1};
  s.numerics.fixedStep = 1e-3;
  s.end = 10;
  Simulation sim(s);
  const Continuum& p = sim.w.particles;
  std::map<std::uint64_t, Vec3d> start;
  for (std::size_t i = 0; i < p.owned; i++) start[p.id[i]] = p.position[i];
  for (int k = 0; k < 500; k++) ASSERT_TRUE(sim.step());
  for (std::size_t i = 1; i < p.owned; i++)
    EXPECT_NEAR(length(p.position[i] - p.position[0]), length(start[p.id[i]] - start[p.id[0]]), 1e-13);
  EXPECT_NEAR(sim.w.pieces.centre[0].z, -0.5 * 0.5 * 0.5, 1e-12);  // leap-frog is exact in free fall
}

TEST(Rigid, MeltingKeepsMomentumAndSplitsThePiece) {
  Simulation sim(turningBar());
  for (int k = 0; k < 20; k++) ASSERT_TRUE(sim.step());
  const LedgerReport before = sim.ledgerReport();
  setColumn(sim.w.particles, 18, 8, 1e6);
  ASSERT_TRUE(sim.step());
  const LedgerReport after = sim.ledgerReport();
  EXPECT_EQ(sim.w.counters.melted, 16);
  ASSERT_EQ(sim.w.pieces.owned, 2u);
  EXPECT_EQ(sim.w.pieces.count[0], 8u * 16);
  EXPECT_EQ(sim.w.pieces.count[1], 9u * 16);
  const double L = length(before.now.angularMomentum);
  EXPECT_LT(length(after.now.momentum - before.now.momentum), 1e-12 * before.now.mass);
  EXPECT_LT(length(after.now.angularMomentum - before.now.angularMomentum), 1e-12 * L);
  EXPECT_NEAR(after.energyResidual, 0, 1e-10 * before.now.kinetic);
  // The enthalpy that the test sets is no part of the budget; kinetic energy is.
  EXPECT_NEAR(after.now.kinetic + after.dissipated, before.now.kinetic + before.dissipated,
              1e-12 * before.now.kinetic);
}

TEST(Rigid, FreezingJoinsPieces) {
  Simulation sim(turningBar());
  setColumn(sim.w.particles, 18, 8, 1e6);
  ASSERT_TRUE(sim.step());
  ASSERT_EQ(sim.w.pieces.owned, 2u);
  for (std::size_t i = 0; i < sim.w.particles.owned; i++) sim.w.particles.enthalpy[i] = -1e5;
  const LedgerReport before = sim.ledgerReport();
  ASSERT_TRUE(sim.step());
  const LedgerReport after = sim.ledgerReport();
  ASSERT_EQ(sim.w.pieces.owned, 1u);
  EXPECT_EQ(sim.w.pieces.count[0], 18u * 16);
  EXPECT_LT(length(after.now.momentum - before.now.momentum), 1e-12 * before.now.mass);
  EXPECT_LT(length(after.now.angularMomentum - before.now.angularMomentum),
            1e-6 * length(before.now.angularMomentum));  // viscous pairs of the step turn, too
  EXPECT_LT(std::abs(after.energyResidual - before.energyResidual), 1e-4 * before.now.kinetic);
}

TEST(Rigid, LoneFrozenParticlesArePieces) {
  Scene s = turningBar();
  s.bodies[0].shape = boxOf({0, 0, 0}, {0.1, 0.1, 0.1});
  s.bodies[0].temperature = 400;
  Simulation sim(s);
  ASSERT_TRUE(sim.step());
  EXPECT_EQ(sim.w.pieces.owned, 0u);
  sim.w.particles.enthalpy[0] = -1e5;
  ASSERT_TRUE(sim.step());
  ASSERT_EQ(sim.w.pieces.owned, 1u);
  EXPECT_EQ(sim.w.pieces.count[0], 1u);
  EXPECT_GT(sim.w.pieces.inertia[0].x, 0);
  for (int k = 0; k < 10; k++) ASSERT_TRUE(sim.step());
  EXPECT_NEAR(velocityOf(sim.w.pieces, 0).z, 0.1, 1e-12);
}

TEST(Rigid, ClampedPiecesStayInPlace) {
  Scene s = freeBox(stone(), 0.1, {0.6, 0.2, 0.2});
  s.domain.gravity = {0, 0, -9.81};
  s.bodies[0].clamp.push_back(boxOf({-0.4, -0.2, -0.2}, {-0.2, 0.2, 0.2}));
  s.numerics.maxStep = 1e-3;
  s.end = 1;
  Simulation sim(s);
  const Vec3d at = sim.w.particles.position[5];
  for (int k = 0; k < 100; k++) ASSERT_TRUE(sim.step());
  EXPECT_EQ(sim.w.pieces.fixed[0], 1);
  EXPECT_TRUE(sim.w.particles.position[5] == at);
  EXPECT_NEAR(sim.ledgerReport().momentumResidual.z, 0, 1e-9);
}

TEST(Rigid, ClampsThatMeltAreRemoved) {
  Scene s = turningBar();
  s.domain.gravity = {0, 0, -9.81};
  s.bodies[0].velocity = s.bodies[0].spin = {};
  s.bodies[0].clamp.push_back(boxOf({0, 0, 0}, {0.1, 1, 1}));
  s.numerics.maxStep = 1e-3;
  s.end = 1;
  Simulation sim(s);
  ASSERT_TRUE(sim.step());
  ASSERT_EQ(sim.w.pieces.fixed[0], 1);
  int clamped = 0;
  Continuum& p = sim.w.particles;
  for (std::size_t i = 0; i < p.owned; i++)
    if (p.clamped[i] == fixedInPlace) p.enthalpy[i] = 1e6, clamped++;
  ASSERT_GT(clamped, 0);
  for (int k = 0; k < 100; k++) ASSERT_TRUE(sim.step());
  EXPECT_EQ(sim.w.counters.melted, clamped);
  for (std::size_t i = 0; i < p.owned; i++) EXPECT_EQ(p.clamped[i], 0);
  for (std::size_t k = 0; k < sim.w.pieces.owned; k++) EXPECT_LT(velocityOf(sim.w.pieces, k).z, -0.3);
}

TEST(Rigid, PeriodicSidesCutNoPiece) {
  Scene s = freeBox(stone(), 0.1, {0.4, 0.4, 0.4});
  s.domain.min = {-0.5, -0.5, -0.5};
  s.domain.max = {0.5, 0.5, 0.5};
  for (auto& side : s.domain.side) side = {Side::Periodic, Side::Periodic};
  s.bodies[0].velocity = {1, 0.5, 0};
  s.bodies[0].spin = {0, 0, 1};
  s.numerics.fixedStep = 5e-3;
  s.end = 10;
  Simulation sim(s);
  const double energy = sim.ledgerReport().now.kinetic;
  for (int k = 0; k < 400; k++) ASSERT_TRUE(sim.step());  // twice through the domain along x
  ASSERT_EQ(sim.w.pieces.owned, 1u);
  EXPECT_NEAR(sim.w.pieces.centre[0].x, 0, 1e-9);
  EXPECT_NEAR(sim.ledgerReport().now.kinetic, energy, 1e-12 * energy);
}

TEST(Rigid, PeriodicDomainsHoldPiecesLongerThanHalfOfThem) {
  Scene s = freeBox(stone(1000), 0.1, {1.4, 0.2, 0.2});
  s.domain.min = {-1, -1, -1};
  s.domain.max = {1, 1, 1};
  s.domain.side[0] = {Side::Periodic, Side::Periodic};
  s.bodies[0].shape.move = {0.7, 0, 0};
  Simulation sim(s);
  const Pieces& p = sim.w.pieces;
  ASSERT_EQ(p.owned, 1u);
  EXPECT_NEAR(p.centre[0].x, 0.7, 1e-9);
  const double mass = 1000 * 1.4 * 0.2 * 0.2;
  const Vec3d exact{mass * 2 * 0.2 * 0.2 / 12, mass * (1.4 * 1.4 + 0.2 * 0.2) / 12,
                    mass * (1.4 * 1.4 + 0.2 * 0.2) / 12};
  double sum = 0, sumExact = 0;  // the principal axes have any order
  for (int a = 0; a < 3; a++) sum += p.inertia[0][a], sumExact += exact[a];
  EXPECT_NEAR(sum, sumExact, 1e-9 * sumExact);
}

TEST(Rigid, SnapshotsContinueWithTheSameBits) {
  const Scene s = waxPieces();
  Simulation straight(s), resumed(s);
  for (int k = 0; k < 36; k++) {
    ASSERT_TRUE(straight.step());
    ASSERT_TRUE(resumed.step());
  }
  resumed.ledgerReport();  // computes stored energies
  straight.ledgerReport();
  WorldSnapshot kept;
  takeSnapshot(resumed.w, kept);
  emptyWorld(resumed.w, resumed.tools);
  resumed.makeHalos();
  restoreSnapshot(kept, resumed.w);
  resumeWorld(resumed.w, resumed.halos(), resumed.tools);
  for (int k = 0; k < 14; k++) {
    ASSERT_TRUE(straight.step());
    ASSERT_TRUE(resumed.step());
  }
  const Continuum &a = straight.w.particles, &b = resumed.w.particles;
  ASSERT_EQ(a.owned, b.owned);
  for (std::size_t i = 0; i < a.owned; i++) {
    ASSERT_EQ(a.id[i], b.id[i]);
    ASSERT_EQ(a.piece[i], b.piece[i]);
    for (int c = 0; c < 3; c++)
      ASSERT_EQ(std::bit_cast<std::uint64_t>(a.position[i][c]),
                std::bit_cast<std::uint64_t>(b.position[i][c]));
  }
}

TEST(Rigid, ParticlesThatLeaveTheDomainTakeTheirMomentum) {
  Scene s = freeBox(stone(1000), 0.1, {0.4, 0.4, 0.4});
  s.domain.max.z = 0.25;
  s.domain.gravity = {0, 0, -9.81};
  s.bodies[0].velocity = {0, 0, 1.5};
  s.bodies[0].spin = {1, 0.5, 0};
  s.numerics.maxStep = 2e-3;
  s.end = 1;
  Simulation sim(s);
  for (int k = 0; k < 150; k++) ASSERT_TRUE(sim.step());
  EXPECT_GT(sim.w.counters.left, 0);
  ASSERT_EQ(sim.w.pieces.owned, 1u);
  EXPECT_EQ(sim.w.pieces.count[0], sim.w.particles.owned);
  const LedgerReport now = sim.ledgerReport();
  // In the step in which particles leave, the remaining ones move with the mass of all.
  EXPECT_LT(length(now.momentumResidual), 0.01 * now.now.mass);
  EXPECT_LT(std::abs(now.energyResidual), 0.02 * now.now.mass);
}

/// A cube of 20 cm that floats in a tank, at a spacing of 4 cm. Returns its draught over its edge, averaged
/// over the second half of the time.
double draught(double density, double seconds, const Numerics& numerics = {}) {
  constexpr double spacing = 0.04, edge = 0.2, depth = 0.4;
  Scene s = emptyScene(spacing, {0, 0, 0}, {0.6, 0.6, 0.9});
  s.domain.gravity = {0, 0, -9.81};
  for (auto& side : s.domain.side) side = {Side::Wall, Side::Wall};
  s.domain.side[2][1] = Side::Open;
  s.materials.emplace_back();
  s.materials[0].name = "water";
  s.materials[0].viscosity = {5, 5};
  s.materials.push_back(stone(density));
  s.numerics = numerics;
  s.numerics.overlap = OverlapRule::RemoveEarlier;
  const double bottom = depth - spacing * std::round(edge * density / 1000 / spacing);
  addBox(s, {0, 0, 0}, {0.6, 0.6, depth});
  addBox(s, {0.2, 0.2, bottom}, {0.4, 0.4, bottom + edge}).material = 1;
  s.end = seconds;
  Simulation sim(s);
  double sum = 0;
  int count = 0;
  while (sim.w.clock.time < s.end) {
    if (!sim.step()) return NAN;
    if (sim.w.clock.time < 0.5 * s.end) continue;
    // The level follows from the volume: below it, water fills the tank except for the immersed part of the
    // cube.
    const double water = [&] {
      double volume = 0;
      const Continuum& p = sim.w.particles;
      for (std::size_t i = 0; i < p.owned; i++)
        if (p.material[i] == 0) volume += p.mass[i] / 1000;
      return volume;
    }();
    const double low = sim.w.pieces.centre[0].z - edge / 2;
    // water + edge^2 (level - low) = area level
    const double level = (water - edge * edge * low) / (0.36 - edge * edge);
    sum += (level - low) / edge;
    count++;
  }
  return sum / count;
}

TEST(Rigid, CubesFloatByArchimedes) {
  constexpr double halfSpacing = 0.1;  // over the edge; the edge of the cube has five particles
  EXPECT_NEAR(draught(500, 1.5), 0.5, halfSpacing);
  EXPECT_NEAR(draught(900, 1.5), 0.9, halfSpacing);
  Numerics incompressible;
  incompressible.solver = PressureSolver::Incompressible;
  incompressible.maxStep = 5e-3;  // liquid without a cube is not stable either without a limit
  EXPECT_NEAR(draught(600, 1.5, incompressible), 0.6, halfSpacing);
  Numerics implicitViscosity;
  implicitViscosity.viscositySolver = ViscositySolver::Implicit;
  EXPECT_NEAR(draught(600, 1, implicitViscosity), 0.6, halfSpacing);
}

TEST(Rigid, ScenesWithoutRigidMaterialHaveNoPieces) {
  Scene s = freeBox(wax(), 0.1, {0.4, 0.4, 0.4});
  s.bodies[0].temperature = 300;
  Simulation sim(s);
  EXPECT_FALSE(sim.w.modules.rigid);
  EXPECT_FALSE(sim.w.particles.piece.active);
  EXPECT_FALSE(sim.w.pieces.id.active);
}

}  // namespace
