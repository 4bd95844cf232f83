// SPDX-License-Identifier: Apache-2.0
// Rigid pieces weld where both surfaces are hot (core/rigid/welding/). The tests compare momentum and energy
// with exact values. They cover cold and other surfaces, time of touch, clamped, sleeping and loaded pieces,
// and fractures.
#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "core/rigid/contact/find_contacts.hpp"
#include "tests/support/rigid/scenes.hpp"

using namespace thaw;
using namespace thaw::test;

namespace {

constexpr double spacing = 0.1, weldsAbove = 1000, density = 7800;  // m, K, kg/m^3

Material iron() {
  Material m = stone(density);
  m.name = "iron";
  m.weldTemperature = weldsAbove;
  m.heatCapacity = {450, 450};
  m.restitution = 0;
  return m;
}

/// An empty scene with iron and steps of 1 ms.
Scene ironScene() {
  Scene s = emptyScene(spacing, {-3, -2, -2}, {3, 2, 2});
  s.materials.push_back(iron());
  s.numerics.maxStep = 1e-3;
  s.end = 10;
  return s;
}

void addGravity(Scene& s) { s.domain.gravity = {0, 0, -9.81}; }

Body& addHotBox(Scene& s, const Vec3d& low, const Vec3d& high) {
  Body& b = addBox(s, low, high);
  b.temperature = weldsAbove + 100;
  return b;
}

bool runUntil(Simulation& sim, double time) {
  while (sim.w.clock.time < time)
    if (!sim.step()) return false;
  return true;
}

/// Two cubes, the second one in motion, and what they become as one rigid body. Cubes have the same moment of
/// inertia about each axis, so their spins are constant.
struct TwoCubes {
  static constexpr double edge[2] = {0.4, 0.6}, dt = 4e-3;
  Vec3d centre[2] = {{-0.2, 0, 0}, {0.305, 0.05, 0}}, velocity[2] = {{}, {-1, 0.2, 0.1}},
        spin[2] = {{0, 0.1, -0.3}, {0.3, -0.2, 0.4}};
  double kinetic[2] = {0, 0};                  ///< J, before and after they weld at the end of a step of dt
  Vec3d momentum, angularMomentum, spinAfter;  ///< about the common centre

  TwoCubes() {
    double mass[2], total = 0, inertia[2];
    Vec3d at[2], middle;
    for (int k = 0; k < 2; k++) {
      mass[k] = density * edge[k] * edge[k] * edge[k];
      inertia[k] = mass[k] * edge[k] * edge[k] / 6;
      at[k] = centre[k] + dt * velocity[k];
      total += mass[k];
      middle += mass[k] * at[k];
      momentum += mass[k] * velocity[k];
      kinetic[0] += 0.5 * (mass[k] * dot(velocity[k], velocity[k]) + inertia[k] * dot(spin[k], spin[k]));
    }
    middle = middle / total;
    Eigen::Matrix3d tensor = Eigen::Matrix3d::Zero();
    for (int k = 0; k < 2; k++) {
      const Vec3d r = at[k] - middle;
      const Eigen::Vector3d e(r.x, r.y, r.z);
      angularMomentum += inertia[k] * spin[k] + mass[k] * cross(r, velocity[k]);
      tensor += inertia[k] * Eigen::Matrix3d::Identity() +
                mass[k] * (dot(r, r) * Eigen::Matrix3d::Identity() - e * e.transpose());
    }
    const Eigen::Vector3d l(angularMomentum.x, angularMomentum.y, angularMomentum.z),
        w = tensor.inverse() * l;
    spinAfter = {w.x(), w.y(), w.z()};
    kinetic[1] = 0.5 * (dot(momentum, momentum) / total + l.dot(w));
  }
};

TEST(RigidWelding, SpinningCubesBecomeOneWithTheExactMotion) {
  const TwoCubes c;
  Scene s = ironScene();
  s.numerics.fixedStep = TwoCubes::dt;
  for (int k = 0; k < 2; k++) {
    const Vec3d half = 0.5 * TwoCubes::edge[k] * Vec3d{1, 1, 1};
    Body& b = addHotBox(s, c.centre[k] - half, c.centre[k] + half);
    b.velocity = c.velocity[k];
    b.spin = c.spin[k];
  }
  Simulation sim(s);
  const Pieces& p = sim.w.pieces;
  ASSERT_EQ(p.owned, 2u);
  const double mass = p.mass[0] + p.mass[1];
  ASSERT_TRUE(sim.step());
  ASSERT_EQ(p.owned, 1u);
  EXPECT_EQ(sim.w.counters.weldedPieces, 1);
  EXPECT_EQ(p.count[0], sim.particles().owned);
  const LedgerReport now = sim.ledgerReport();
  EXPECT_NEAR(p.mass[0], mass, 1e-14 * mass);
  EXPECT_LT(length(p.momentum[0] - c.momentum), 1e-13 * length(c.momentum));
  EXPECT_LT(length(p.angularMomentum[0] - c.angularMomentum), 1e-12 * length(c.angularMomentum));
  EXPECT_LT(length(spinOf(p, 0, p.angularMomentum[0]) - c.spinAfter), 1e-12 * length(c.spinAfter));
  EXPECT_NEAR(now.dissipated, c.kinetic[0] - c.kinetic[1], 1e-12 * c.kinetic[0]);
  EXPECT_NEAR(now.now.kinetic, c.kinetic[1], 1e-12 * c.kinetic[0]);
  EXPECT_GT(now.dissipated, 0.1 * c.kinetic[0]);
  EXPECT_LT(std::abs(now.energyResidual), 1e-12 * now.energyScale);
  for (int k = 0; k < 50; k++) ASSERT_TRUE(sim.step());
  EXPECT_LT(length(p.angularMomentum[0] - c.angularMomentum), 1e-12 * length(c.angularMomentum));
  EXPECT_EQ(sim.w.counters.weldedPieces, 1);
}

/// Number of pieces that two boxes in touch are after some steps.
std::size_t piecesOfTwo(double firstTemperature, double secondTemperature, int secondMaterial) {
  Scene s = ironScene();
  s.materials.push_back(iron());
  s.materials[1].name = "steel";
  addBox(s, {-0.4, -0.2, -0.2}, {0, 0.2, 0.2}).temperature = firstTemperature;
  Body& second = addBox(s, {0, -0.1, -0.2}, {0.4, 0.3, 0.2});
  second.temperature = secondTemperature;
  second.material = secondMaterial;
  Simulation sim(s);
  for (int k = 0; k < 3; k++) EXPECT_TRUE(sim.step());
  return sim.w.pieces.owned;
}

TEST(RigidWelding, BothSurfacesMustBeHotAndOfOneMaterial) {
  EXPECT_EQ(piecesOfTwo(1100, 1001, 0), 1u);
  EXPECT_EQ(piecesOfTwo(1100, 999, 0), 2u);
  EXPECT_EQ(piecesOfTwo(999, 999, 0), 2u);
  EXPECT_EQ(piecesOfTwo(1100, 1100, 1), 2u);
}

TEST(RigidWelding, ThreePiecesInARowJoinAtOnce) {
  Scene s = ironScene();
  for (int k = 0; k < 3; k++) addHotBox(s, {0.4 * k, 0, 0}, {0.4 * (k + 1), 0.4, 0.4}).velocity.y = k;
  Simulation sim(s);
  ASSERT_TRUE(sim.step());
  ASSERT_EQ(sim.w.pieces.owned, 1u);
  EXPECT_EQ(sim.w.counters.weldedPieces, 2);
  EXPECT_NEAR(velocityOf(sim.w.pieces, 0).y, 1, 1e-13);
  EXPECT_LT(std::abs(sim.ledgerReport().energyResidual), 1e-12 * sim.ledgerReport().energyScale);
}

TEST(RigidWelding, PiecesReboundAndWeldToAClampedOneWhenTheyHaveTouchedLongEnough) {
  Scene s = ironScene();
  addGravity(s);
  s.materials[0].restitution = 0.5;
  s.materials[0].weldTime = 0.05;
  addHotBox(s, {-0.4, -0.4, -0.4}, {0.4, 0.4, 0})
      .clamp.push_back(boxOf({-0.5, -0.5, -0.5}, {-0.2, 0.5, 0.1}));
  addHotBox(s, {0, -0.2, 0.02}, {0.4, 0.2, 0.42}).velocity = {0, 0, -1};
  Simulation sim(s);
  const Pieces& p = sim.w.pieces;
  ASSERT_TRUE(runUntil(sim, 0.05));
  ASSERT_EQ(p.owned, 2u);
  EXPECT_GT(velocityOf(p, 1).z, 0.1);
  ASSERT_TRUE(runUntil(sim, 0.5));
  ASSERT_EQ(p.owned, 1u);
  EXPECT_EQ(p.fixed[0], 1);
  const Continuum& c = sim.particles();
  const Vec3d at = c.position[c.owned - 1];
  ASSERT_TRUE(runUntil(sim, 0.6));
  EXPECT_TRUE(c.position[c.owned - 1] == at);
  const LedgerReport now = sim.ledgerReport();
  EXPECT_EQ(now.now.kinetic, 0);
  EXPECT_LT(length(now.momentumResidual), 1e-9 * now.now.mass);
  EXPECT_LT(std::abs(now.energyResidual), 1e-3 * now.energyScale);
}

/// Two boxes on a floor.
Scene stackOfTwo(double weldTime) {
  Scene s = ironScene();
  addGravity(s);
  addFloor(s);
  s.materials[0].weldTime = weldTime;
  addHotBox(s, {-0.2, -0.2, 0}, {0.2, 0.2, 0.4});
  addHotBox(s, {-0.15, -0.2, 0.4}, {0.25, 0.2, 0.8});
  return s;
}

/// Number of particles with an impulse of a contact with a piece.
std::size_t touchingPieces(const Continuum& p) {
  std::size_t n = 0;
  for (std::size_t i = 0; i < p.owned; i++)
    n += p.contactPartner[i] != 0 && !(p.contactPartner[i] & obstacleBit);
  return n;
}

TEST(RigidWelding, ImpulsesBetweenWeldedPiecesVanish) {
  Simulation sim(stackOfTwo(0.05));
  ASSERT_TRUE(runUntil(sim, 0.045));
  ASSERT_EQ(sim.w.pieces.owned, 2u);
  EXPECT_GT(touchingPieces(sim.particles()), 0u);
  ASSERT_TRUE(runUntil(sim, 0.055));
  ASSERT_EQ(sim.w.pieces.owned, 1u);
  EXPECT_EQ(touchingPieces(sim.particles()), 0u);
  const double weight = 9.81 * sim.w.pieces.mass[0] * sim.w.clock.stepDt;
  EXPECT_NEAR(sim.w.pieces.contactImpulse[0].z, weight, 1e-2 * weight);
}

TEST(RigidWelding, SleepingPiecesWakeAsTheyWeld) {
  Scene s = stackOfTwo(0.3);
  s.numerics.sleepSpeed = 0.05;
  s.numerics.sleepAfter = 0.05;
  Simulation sim(s);
  const Pieces& p = sim.w.pieces;
  ASSERT_TRUE(runUntil(sim, 0.29));
  ASSERT_EQ(p.owned, 2u);
  EXPECT_TRUE(p.sleeping[0] && p.sleeping[1]);
  EXPECT_GT(touchingPieces(sim.particles()), 0u);
  ASSERT_TRUE(runUntil(sim, 0.305));
  ASSERT_EQ(p.owned, 1u);
  EXPECT_FALSE(p.sleeping[0]);
  EXPECT_EQ(touchingPieces(sim.particles()), 0u);
  ASSERT_TRUE(runUntil(sim, 0.5));
  EXPECT_TRUE(p.sleeping[0]);
  EXPECT_LT(length(sim.ledgerReport().momentumResidual), 1e-6 * sim.ledgerReport().now.mass);
}

/// Stiff iron that breaks.
void makeBrittle(Material& m, double strength) {
  m.strength = strength;
  m.impactModulus = 70e9;
}

TEST(RigidWelding, LoadsAtRestAreNoImpactsOnWeldedPieces) {
  Scene s = stackOfTwo(0.1);
  makeBrittle(s.materials[0], 1e12);
  s.materials.push_back(stone(3 * density));
  addBox(s, {-0.1, -0.2, 0.8}, {0.3, 0.2, 1.2}).material = 1;
  Simulation sim(s);
  ASSERT_TRUE(runUntil(sim, 0.05));
  sim.w.scene.materials[0].strength = 1e4;  // below the stress of these loads as impacts
  ASSERT_TRUE(runUntil(sim, 0.2));
  EXPECT_EQ(sim.w.counters.weldedPieces, 1);
  EXPECT_EQ(sim.w.counters.brokenPieces, 0);
}

/// A hot bar that breaks on a ridge.
Scene brittleBar() {
  Scene s = ironScene();
  addGravity(s);
  makeBrittle(s.materials[0], 40e6);
  addHotBox(s, {-1, -0.1, 0.02}, {1, 0.1, 0.22}).velocity = {0, 0, -6};
  s.obstacles.emplace_back();
  s.obstacles.back().name = "ridge";
  s.obstacles.back().shape = boxOf({-0.1, -0.5, -0.3}, {0.1, 0.5, 0});
  return s;
}

TEST(RigidWelding, FracturesDoNotWeldWhileTheyAreHot) {
  Simulation sim(brittleBar());
  for (int k = 0; k < 20; k++) ASSERT_TRUE(sim.step());
  ASSERT_GT(sim.w.counters.brokenPieces, 0);
  EXPECT_GT(sim.w.pieces.owned, 1u);
  EXPECT_EQ(sim.w.counters.weldedPieces, 0);
  const Continuum& p = sim.particles();
  EXPECT_GT(std::count(p.touchTime.data(), p.touchTime.data() + p.owned, atFracture), 0);
}

TEST(RigidWelding, FracturesMayWeldAfterTheyHaveCooled) {
  Scene s = brittleBar();
  s.domain.gravity = {};
  s.thermostats.emplace_back();
  s.thermostats[0].start = 0.01;
  s.thermostats[0].over = 0.001;
  s.thermostats[0].temperature = weldsAbove - 100;
  Simulation sim(s);
  const Continuum& p = sim.particles();
  const auto fractured = [&] {
    return std::count(p.touchTime.data(), p.touchTime.data() + p.owned, atFracture);
  };
  ASSERT_TRUE(runUntil(sim, 0.009));
  EXPECT_GT(fractured(), 0);
  ASSERT_TRUE(runUntil(sim, 0.02));
  EXPECT_EQ(fractured(), 0);
}

TEST(RigidWelding, ScenesWithoutItHaveNoColumnOfIt) {
  Scene s = freeBox(stone(), spacing, {0.4, 0.4, 0.4});
  s.end = 1;
  Simulation sim(s);
  EXPECT_FALSE(sim.w.modules.pieceWelding);
  EXPECT_FALSE(sim.particles().touchTime.active);
  EXPECT_FALSE(sim.w.modules.heat);
}

}  // namespace
