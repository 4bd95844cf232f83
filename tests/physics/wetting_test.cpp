// SPDX-License-Identifier: Apache-2.0
// Surface tension by temperature, and contact angles (core/walls/wall_surface_energy.hpp).
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/simulation/time/integrate.hpp"
#include "core/terms/find_modules.hpp"
#include "core/walls/wall_surface_energy.hpp"
#include "tests/support/simulation.hpp"

namespace thaw {
namespace {

using namespace thaw::test;

constexpr double degree = std::numbers::pi / 180;

/// A block of liquid without viscosity, in double precision.
Scene block(double spacing, const Vec3d& low, const Vec3d& high) {
  Scene s = emptyScene(spacing, {-2, -2, -2}, {2, 2, 2});
  s.materials.emplace_back();
  s.materials[0].density = 1;
  s.materials[0].surfaceTension = 1;
  s.numerics.precision = Precision::Double;
  addBox(s, low, high);
  return s;
}

/// The block with a tension that falls from 1 to 0.2 along z.
void heat(Scene& s) {
  Material& m = s.materials[0];
  m.surfaceTensionTable = {{300, 1}, {320, 0.2}};
  m.conductivity = {0.1, 0.1};
  m.heatCapacity = {10, 10};
  s.bodies[0].temperature = 310;
  s.bodies[0].temperatureGradient = {0, 0, 15};
}

double energyOf(const World& w) {
  double e = 0;
  for (std::size_t i = 0; i < w.particles.owned; i++) e += w.particles.interaction[i];
  return e;
}

/// Compares forces of some particles with differences of the energy.
void expectGradient(Scene s) {
  s.end = 0.02;
  Simulation run(s);
  ASSERT_TRUE(run.run());
  Continuum& p = run.w.particles;
  const auto energyWith = [&](std::size_t row, const Vec3d& shift) {
    p.position[row] += shift;
    evaluate(run.w, run.halos(), run.tools, 0);
    const double e = energyOf(run.w);
    p.position[row] -= shift;
    return e;
  };
  std::size_t lowest = 0;
  for (std::size_t i = 0; i < p.owned; i++)
    if (p.position[i].z < p.position[lowest].z) lowest = i;
  for (const std::size_t row : {lowest, std::size_t{5}, p.owned / 2, p.owned - 3}) {
    energyWith(row, {});
    const Vec3d f = p.force[row];
    double scale = 0;
    for (std::size_t i = 0; i < p.owned; i++) scale = std::max(scale, length(p.force[i]));
    constexpr double step = 2e-4;  // shorter steps show the rounding of the relative density
    for (int a = 0; a < 3; a++) {
      Vec3d d{};
      d[a] = step;
      EXPECT_NEAR((energyWith(row, d * -1.0) - energyWith(row, d)) / (2 * step), f[a], 5e-4 * scale)
          << row << " " << a;
    }
  }
}

TEST(TensionByTemperature, ForcesAreTheGradientAtFixedTension) {
  Scene s = block(0.4, {-0.8, -0.8, -0.8}, {0.8, 0.8, 0.8});
  heat(s);
  expectGradient(s);
}

TEST(ContactAngle, ForcesAreTheGradientAtAWall) {
  for (const double angle : {20.0, 70.0, 130.0, 180.0}) {
    SCOPED_TRACE(angle);
    Scene s = block(0.4, {-0.8, -0.8, 0}, {0.8, 0.8, 1.2});
    s.materials[0].contactAngle = angle * degree;
    s.materials[0].soundSpeed = 1e-3;  // the pressure of walls follows from tables and is less exact
    addFloor(s);
    expectGradient(s);
  }
}

TEST(ContactAngle, ForcesAreTheGradientBetweenWallsOfTwoAngles) {
  Scene s = block(0.4, {-0.8, -0.8, 0}, {0.8, 0.8, 0.8});
  addFloor(s);
  addFloor(s).shape.move = {0, 0, 0.8};
  s.obstacles[0].contactAngle = 40 * degree;
  s.obstacles[1].contactAngle = 120 * degree;
  s.obstacles[1].shape.rotate = {std::numbers::pi, 0, 0};
  s.materials[0].soundSpeed = 1e-3;
  expectGradient(s);
}

// The warm end is pulled to the cold one, and the forces of all particles sum to zero.
TEST(TensionByTemperature, PullsToTheColdEndAndKeepsMomentum) {
  Scene s = block(0.1, {-0.3, -0.3, -0.6}, {0.3, 0.3, 0.6});
  s.materials[0].viscosity = {0.1, 0.1};
  heat(s);
  s.end = 0.05;
  Simulation run(s);
  const Continuum& p = run.particles();
  const auto surfaceForce = [&](double from, double to) {
    Vec3d sum{};
    for (std::size_t i = 0; i < p.owned; i++)
      if (p.position[i].z > from && p.position[i].z < to) sum += forceOf(run.w.particles, run.w.scene, i);
    return sum;
  };
  EXPECT_LT(length(surfaceForce(-2, 2)), 1e-12);
  // Between sections, at least about perimeter times difference of the tension.
  EXPECT_LT(surfaceForce(-0.3, 0.3).z, -0.5 * 2.4 * 0.6 * 0.6);
  ASSERT_TRUE(run.run());
  Vec3d momentum{};
  double moved = 0;
  for (std::size_t i = 0; i < p.owned; i++)
    momentum += p.velocity[i] * p.mass[i], moved += length(p.velocity[i]) * p.mass[i];
  EXPECT_LT(length(momentum), 1e-10 * moved);
}

// The ledger has the energy that the surface loses as its tension falls.
TEST(TensionByTemperature, LedgerClosesWhileTheLiquidWarms) {
  Scene s = block(0.1, {-0.4, -0.4, 0}, {0.4, 0.4, 0.5});
  heat(s);
  addFloor(s);
  s.materials[0].viscosity = {0.2, 0.2};
  s.materials[0].contactAngle = 60 * degree;
  s.bodies[0].temperatureGradient = {};
  s.bodies[0].temperature = 300;
  s.materials[0].heatSource = 500;  // 25 K in the run
  s.end = 0.5;
  Simulation run(s);
  const double before = energyOf(run.w);
  ASSERT_TRUE(run.run());
  const LedgerReport r = run.ledgerReport();
  EXPECT_GT(r.phaseJump, 0.1 * before);
  EXPECT_LT(std::abs(r.energyResidual), 0.005 * before);
  EXPECT_LT(std::abs(r.heatResidual), 1e-9 * std::abs(r.heatIn));
}

/// Height of the centre of a drop that starts as a half cube, at the end.
double heightAt(double angle) {
  Scene s = block(0.125, {-0.5, -0.5, 0}, {0.5, 0.5, 0.5});
  s.materials[0].viscosity = {0.2, 0.2};
  s.numerics.precision = Precision::Single;
  addFloor(s).contactAngle = angle * degree;
  s.end = 1;
  Simulation run(s);
  EXPECT_TRUE(run.run());
  double height = 0;
  for (std::size_t i = 0; i < run.particles().owned; i++) height += run.particles().position[i].z;
  return height / static_cast<double>(run.particles().owned);
}

TEST(ContactAngle, DropsStandHigherOnWallsThatTheyWetLess) {
  const double wets = heightAt(40), right = heightAt(90), beads = heightAt(140);
  EXPECT_LT(wets, 0.85 * right);
  EXPECT_GT(beads, 1.1 * right);
}

// An obstacle's angle replaces that of the material. Scenes without angles have no module.
TEST(ContactAngle, ObstacleOverridesTheMaterial) {
  Material m;
  m.contactAngle = 30 * degree;
  Obstacle o;
  const double wets = wettingOf(m, o);
  o.contactAngle = 120 * degree;
  EXPECT_LT(wettingOf(m, o), 0);
  EXPECT_GT(wets, 0.5);
  EXPECT_EQ(wettingOf({}, o), wettingOf(m, o));
  Scene s = block(0.2, {-0.4, -0.4, 0}, {0.4, 0.4, 0.4});
  addFloor(s);
  EXPECT_FALSE(modulesOf(s).contactAngle);
  EXPECT_FALSE(modulesOf(s).tensionTable);
  EXPECT_FALSE(modulesOf(s).heat);
  s.materials[0].contactAngle = 30 * degree;
  EXPECT_TRUE(modulesOf(s).contactAngle);
}

// The reason that `thaw check` prints names an angle that acts.
TEST(ContactAngle, ReasonNamesAnAngleThatActs) {
  const auto reasonOf = [](const Scene& s) {
    for (const std::string& why : modulesOf(s).why)
      if (why.starts_with("contact angles")) return why;
    return std::string();
  };
  Scene s = block(0.2, {-0.4, -0.4, 0}, {0.4, 0.4, 0.4});
  s.materials[0].contactAngle = 30 * degree;
  EXPECT_EQ(reasonOf(s), "");  // no walls
  addFloor(s).contactAngle = 120 * degree;
  EXPECT_NE(reasonOf(s).find("'floor' at 120 degrees"), std::string::npos);
  s.domain.side[0][1] = Side::Wall;
  EXPECT_NE(reasonOf(s).find("walls at 30 degrees"), std::string::npos);
}

}  // namespace
}  // namespace thaw
