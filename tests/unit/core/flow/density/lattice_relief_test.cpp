// SPDX-License-Identifier: Apache-2.0
// Liquid beside solids: the density that solids carry, and the force that lets liquid slip along them
// (core/fluid/laws/lattice_relief.hpp).
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/simulation.hpp"

namespace thaw {
namespace {

using test::Simulation;

constexpr double spacing = 0.1, soundSpeed = 10;

/// A soft cube of 4^3 particles inside a periodic box of 10^3 that liquid fills. Weightless.
Scene cubeInLiquid() {
  Scene s = test::emptyScene(spacing, {0, 0, 0}, {1, 1, 1});
  for (auto& side : s.domain.side) side = {Side::Periodic, Side::Periodic};
  s.materials.resize(2);
  s.materials[0].name = "rubber";
  s.materials[0].young = {1e5, 0};
  s.materials[1].name = "water";
  s.materials[1].viscosity = {0, 0};
  s.materials[1].soundSpeed = soundSpeed;
  test::carryDensity(s, 0.2);
  s.numerics.correctedGradients = true;
  s.numerics.overlap = OverlapRule::RemoveLater;
  test::addBox(s, {0.3, 0.3, 0.3}, {0.7, 0.7, 0.7}).material = 0;
  test::addBox(s, {0, 0, 0}, {1, 1, 1}).material = 1;
  s.end = 0.05;
  return s;
}

/// Sets the carried relative density of liquid to 1 + at(position).
template<class Field> void compress(Simulation& r, Field at) {
  Continuum& p = r.particles();
  for (std::size_t i = 0; i < p.owned; i++)
    if (p.phase[i] == Liquid) p.compression[i] = at(p.position[i]);
}

/// The same for all particles.
template<class Field> void compressAll(Simulation& r, Field at) {
  Continuum& p = r.particles();
  for (std::size_t i = 0; i < p.owned; i++) p.compression[i] = at(p.position[i]);
}

/// Calls check(row) for the outermost layer of the cube, which has liquid nearby.
template<class Check> void eachWetSolid(const Continuum& p, Check check) {
  for (std::size_t i = 0; i < p.owned; i++) {
    const Vec3d off = p.position[i] - Vec3d{0.5, 0.5, 0.5};
    const double depth = 0.2 - std::max({std::abs(off.x), std::abs(off.y), std::abs(off.z)});
    if (p.phase[i] == Solid && depth < spacing) check(i);
  }
}

TEST(LatticeRelief, SolidsKeepTheMeanDensityOfLiquidNearby) {
  Simulation r(cubeInLiquid());
  compressAll(r, [](const Vec3d&) { return 2e-3; });
  ASSERT_TRUE(r.step());
  const Continuum& p = r.particles();
  eachWetSolid(p, [&](std::size_t i) { EXPECT_NEAR(p.compression[i], 2e-3, 1e-8); });
}

TEST(LatticeRelief, SolidsApproachTheDensityOfLiquidNearby) {
  Simulation r(cubeInLiquid());
  compress(r, [](const Vec3d&) { return 2e-3; });
  ASSERT_TRUE(r.step());
  const Continuum& p = r.particles();
  eachWetSolid(p, [&](std::size_t i) {
    EXPECT_GT(p.compression[i], 1e-4);
    EXPECT_LT(p.compression[i], 2e-3);
  });
}

TEST(LatticeRelief, SolidsKeepTheHydrostaticDensity) {
  Scene s = cubeInLiquid();
  const double g = 9.81;
  s.domain.gravity = {0, 0, -g};
  Simulation r(s);
  const auto hydrostatic = [&](const Vec3d& x) { return g / (soundSpeed * soundSpeed) * (1 - x.z); };
  compressAll(r, hydrostatic);
  ASSERT_TRUE(r.step());
  const Continuum& p = r.particles();
  eachWetSolid(p, [&](std::size_t i) {
    EXPECT_NEAR(p.compression[i], hydrostatic(p.position[i]), 1e-3 * hydrostatic({0, 0, 0}));
  });
}

TEST(LatticeRelief, VanishesOnALattice) {
  Simulation r(cubeInLiquid());
  compress(r, [](const Vec3d&) { return 2e-3; });
  ASSERT_TRUE(r.step());
  const Continuum& p = r.particles();
  const double largest = 1000 * soundSpeed * soundSpeed * 2e-3 * spacing * spacing;  // pressure on a face
  for (std::size_t i = 0; i < p.owned; i++) EXPECT_LT(length(wide(p.relief[i])), 1e-4 * largest);
}

/// Force (N) along x on the liquid beside the middle of the cube's face towards +y. The cube is displaced by
/// `way` (m) along x. The pressure is uniform.
double forceAlongFace(double way, bool relieved, bool fixed = false) {
  Scene s = cubeInLiquid();
  if (fixed) s.bodies[0].clamp = {s.bodies[0].shape};
  Simulation r(s);
  Continuum& p = r.particles();
  if (!relieved) p.deactivate(p.relief);
  compress(r, [](const Vec3d&) { return 2e-3; });
  for (std::size_t i = 0; i < p.owned; i++)
    if (p.phase[i] == Solid) p.position[i].x += way;
  EXPECT_TRUE(r.step());
  double force = 0;
  for (std::size_t i = 0; i < p.owned; i++) {
    const Vec3d x = p.position[i];
    if (x.y < 0.7 || x.y > 0.8 || std::abs(x.x - 0.5) > 0.1 || std::abs(x.z - 0.5) > 0.1) continue;
    force += p.acceleration[i].x * p.mass[i];
  }
  return force;
}

TEST(LatticeRelief, LessensTheForceOfTheLatticeAlongAFace) {
  const double without = forceAlongFace(0.1 * spacing, false), with = forceAlongFace(0.1 * spacing, true);
  EXPECT_GT(std::abs(without), 0);
  EXPECT_GT(with * without, 0);
  EXPECT_LT(std::abs(with), 0.8 * std::abs(without));
}

TEST(LatticeRelief, DoesNotActAlongFixedSolids) {
  const double without = forceAlongFace(0.1 * spacing, false, true),
               with = forceAlongFace(0.1 * spacing, true, true);
  EXPECT_GT(std::abs(without), 0);
  EXPECT_EQ(with, without);
}

TEST(LatticeRelief, ActsAlongTheSolid) {
  Simulation r(cubeInLiquid());
  Continuum& p = r.particles();
  compress(r, [](const Vec3d&) { return 2e-3; });
  for (std::size_t i = 0; i < p.owned; i++)
    if (p.phase[i] == Solid) p.position[i] += Vec3d{0.05, 0.02, 0} * spacing;
  ASSERT_TRUE(r.step());
  double across = 0, along = 0;  // beside the middle of the faces towards +x
  for (std::size_t i = 0; i < p.owned; i++) {
    const Vec3d x = p.position[i];
    if (x.x < 0.7 || x.x > 0.8 || std::abs(x.y - 0.5) > 0.1 || std::abs(x.z - 0.5) > 0.1) continue;
    across = std::max(across, std::abs(static_cast<double>(p.relief[i].x)));
    along = std::max(along, std::abs(static_cast<double>(p.relief[i].y)));
  }
  EXPECT_GT(along, 0);
  EXPECT_LT(across, 0.05 * along);
}

TEST(LatticeRelief, ConservesMomentumAndRecordsItsWork) {
  Scene s = cubeInLiquid();
  s.bodies[0].velocity = {1, 0.5, 0};
  Simulation r(s);
  compress(r, [](const Vec3d&) { return 2e-3; });
  ASSERT_TRUE(r.run());
  double largest = 0;
  Vec3d momentum;
  const Continuum& p = r.particles();
  for (std::size_t i = 0; i < p.owned; i++) {
    largest = std::max(largest, length(wide(p.relief[i])));
    momentum += p.velocity[i] * p.mass[i];
  }
  EXPECT_GT(largest, 0);
  const double start = 64 * spacing * spacing * spacing * 1000;
  EXPECT_NEAR(momentum.x, start * 1, 1e-9 * start);
  EXPECT_NEAR(momentum.y, start * 0.5, 1e-9 * start);
}

}  // namespace
}  // namespace thaw
