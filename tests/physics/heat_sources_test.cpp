// SPDX-License-Identifier: Apache-2.0
// Lamps, lasers and heated regions over whole steps: absorbed power, shadows, the heat balance.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/heat/sources/heat_sources.hpp"
#include "tests/support/simulation.hpp"

namespace thaw::test {
namespace {

constexpr double pi = std::numbers::pi;

/// A solid block of 1 m x 1 m x 0.5 m below z = 0 that does not conduct.
Scene block(double spacing = 0.05) {
  Scene s = emptyScene(spacing, {-2, -2, -1}, {2, 2, 2});
  s.materials.emplace_back();
  Material& m = s.materials[0];
  m.name = "stuff";
  m.young = {1e6, 0};
  m.absorptivity = 0.5;
  addBox(s, {-0.5, -0.5, -0.5}, {0.5, 0.5, 0}).temperature = 300;
  s.end = 0.01;
  return s;
}

Lamp sun(const Vec3d& direction) {
  Lamp l;
  l.name = "sun";
  l.kind = LampKind::Direction;
  l.irradiance = 1000;
  l.direction = direction;
  return l;
}

Lamp bulb(const Vec3d& position) {
  Lamp l;
  l.name = "bulb";
  l.power = 1000;
  l.position = position;
  return l;
}

Laser laserAt(const Vec3d& position, double radius) {
  Laser l;
  l.name = "laser";
  l.power = 100;
  l.radius = radius;
  l.position = position;
  return l;
}

/// Fraction of the sphere around a point that a rectangle |x| < a, |y| < b covers at a distance h below it.
double solidAngleOf(double a, double b, double h) {
  return 4 * std::atan(a * b / (h * std::sqrt(a * a + b * b + h * h))) / (4 * pi);
}

/// Takes some steps. Checks that the heat balance closes, and that the sources' energies add up.
LedgerReport balanceOf(Simulation& run, int steps = 3) {
  for (int k = 0; k < steps; k++) EXPECT_TRUE(run.step());
  const LedgerReport l = run.ledgerReport();
  EXPECT_LE(std::abs(l.heatResidual), 1e-15 * l.now.internal);
  EXPECT_NEAR(l.heatIn, l.lamps.absorbed + l.lasers.absorbed + l.regions.absorbed, 1e-13 * l.heatIn);
  EXPECT_GE(l.lamps.missed(), -1e-13 * l.lamps.given);
  EXPECT_GE(l.lasers.missed(), -1e-13 * l.lasers.given);
  return l;
}

double powerOn(const Simulation& run, const LedgerReport& l, const SourceReport& s) {
  return (l.heatIn > 0 ? s.absorbed + s.reflected : 0) / run.w.clock.time;
}

}  // namespace

TEST(Laser, GivesABlockItsWholePowerAtAnySpacingAndAngle) {
  for (const double spacing : {0.05, 0.04}) {
    for (const Vec3d& direction : {Vec3d{0, 0, -1}, Vec3d{0.5, 0.3, -1}, Vec3d{1, 1, -1}}) {
      for (const double depth : {0.0, 0.1}) {
        Scene s = block(spacing);
        s.lasers = {laserAt({0.013, 0.007, 0}, 0.1)};
        s.lasers[0].direction = direction;
        s.lasers[0].absorptionDepth = depth;
        Simulation run(s);
        const LedgerReport l = balanceOf(run);
        EXPECT_NEAR(l.lasers.given, 100 * run.w.clock.time, 1e-12);
        EXPECT_NEAR(l.lasers.absorbed / l.lasers.given, 0.5, 0.0005);
        EXPECT_NEAR(l.lasers.missed() / l.lasers.given, 0, 0.001);
      }
    }
  }
}

TEST(Laser, HeatsTheTopLayerByItsProfile) {
  Scene s = block();
  s.lasers = {laserAt({0.11, 0.06, 0}, 0.15)};
  Simulation run(s);
  balanceOf(run, 1);
  const Continuum& p = run.particles();
  double square = 0, first = 0, sum = 0;
  for (std::size_t i = 0; i < p.owned; i++) {
    const auto absorbed = static_cast<double>(p.absorbed[i]);
    EXPECT_TRUE(p.position[i].z > -0.05 || absorbed == 0);
    const Vec3d d = p.position[i] - Vec3d{0.11, 0.06, 0};
    sum += absorbed;
    first += absorbed * d.x;
    square += absorbed * (d.x * d.x + d.y * d.y);
  }
  EXPECT_NEAR(sum, 50, 0.05);
  EXPECT_NEAR(first / sum, 0, 0.002);
  EXPECT_NEAR(std::sqrt(square / sum), 0.15 / std::numbers::sqrt2, 0.005);
}

TEST(Laser, IsAbsorbedInDepthByBeersLaw) {
  Scene s = block();
  s.lasers = {laserAt({0, 0, 0}, 0.2)};
  s.lasers[0].absorptionDepth = 0.1;
  Simulation run(s);
  balanceOf(run, 1);
  const Continuum& p = run.particles();
  double layer[2] = {0, 0};
  for (std::size_t i = 0; i < p.owned; i++)
    for (int k = 0; k < 2; k++)
      if (std::abs(p.position[i].z + 0.025 + 0.1 * k) < 0.01) layer[k] += static_cast<double>(p.absorbed[i]);
  EXPECT_NEAR(layer[1] / layer[0], std::exp(-1), 1e-3);
}

/// The particles of a block have rounded edges. Under oblique light, its outline is a fifth of a spacing
/// inside the outline with sharp edges.
constexpr double roundEdges = 0.04;

TEST(Lamp, FromADirectionHeatsTheProjectedArea) {
  for (const auto& [direction, area] : {std::pair{Vec3d{0, 0, -1}, 1.0}, std::pair{Vec3d{1, 0, 0}, 0.5},
                                        std::pair{Vec3d{1, 0, -1}, (1 + 0.5) / std::sqrt(2.0)},
                                        std::pair{Vec3d{1, 1, -1}, (1 + 2 * 0.5) / std::sqrt(3.0)}}) {
    Scene s = block();
    s.lamps = {sun(direction)};
    Simulation run(s);
    const LedgerReport l = balanceOf(run);
    const bool faceOn = std::abs(direction.x) + std::abs(direction.y) + std::abs(direction.z) == 1;
    EXPECT_NEAR(powerOn(run, l, l.lamps) / (1000 * area), 1, faceOn ? 0.01 : roundEdges);
    EXPECT_NEAR(l.lamps.absorbed, l.lamps.reflected, 1e-12 * l.lamps.absorbed);
  }
}

TEST(Lamp, AtAPointHeatsTheSolidAngle) {
  for (const double h : {0.3, 1.0}) {
    Scene s = block();
    s.lamps = {bulb({0, 0, h})};
    Simulation run(s);
    const LedgerReport l = balanceOf(run);
    EXPECT_NEAR(l.lamps.given, 1000 * run.w.clock.time, 1e-10);
    EXPECT_NEAR(powerOn(run, l, l.lamps) / (1000 * solidAngleOf(0.5, 0.5, h)), 1, roundEdges);
  }
  Scene s = block();
  s.lamps = {bulb({0, 0, -0.25})};  // inside: nothing escapes
  Simulation run(s);
  const LedgerReport l = balanceOf(run);
  EXPECT_NEAR(powerOn(run, l, l.lamps) / 1000, 1, 1e-3);
}

TEST(Lamp, WithAnAreaShinesToOneSideByLambertsLaw) {
  Scene s = block();
  Lamp l = bulb({0, 0, 0.5});
  l.kind = LampKind::Area;
  l.width = l.depth = 0.01;
  s.lamps = {l};
  Simulation run(s);
  const LedgerReport report = balanceOf(run);
  // Form factor of a small area to a parallel rectangle, from its four quarters
  const double a = 1,
               factor = 4 / (2 * pi) * 2 * a / std::sqrt(1 + a * a) * std::atan(a / std::sqrt(1 + a * a));
  EXPECT_NEAR(powerOn(run, report, report.lamps) / (1000 * factor), 1, roundEdges);
  s.lamps[0].direction = {0, 0, 1};
  Simulation away(s);
  EXPECT_EQ(balanceOf(away).lamps.absorbed, 0);
  s.lamps[0].direction = {1, 0, 0};  // sees half of the block, in a plane through its normal
  Simulation along(s);
  const LedgerReport side = balanceOf(along);
  EXPECT_GT(side.lamps.absorbed, 0);
  EXPECT_LT(side.lamps.absorbed, 0.5 * report.lamps.absorbed);
}

/// Largest error of the shadow's edge, x = edge, on the block's top. It is the distance of a particle that is
/// lit on the dark side (x > edge), or at least half dark on the lit side.
double errorOfShadow(const Continuum& p, double edge, double full) {
  double error = 0;
  for (std::size_t i = 0; i < p.owned; i++) {
    if (p.position[i].z < -0.05 || p.position[i].z > 0 || std::abs(p.position[i].y) > 0.4) continue;
    if (std::abs(p.position[i].x) > 0.4) continue;
    const double x = p.position[i].x - edge;
    const bool lit = static_cast<double>(p.absorbed[i]) > 0.5 * full;
    if (lit == (x > 0)) error = std::max(error, std::abs(x));
  }
  return error;
}

TEST(Shadow, OfAnObstacleHasItsEdgeWithinASpacing) {
  Scene s = block();
  Obstacle& plate = s.obstacles.emplace_back();
  plate.name = "plate";
  plate.shape = boxOf({0.113, -1, 0.9}, {1.5, 1, 1});
  s.lamps = {sun({0, 0, -1})};
  Simulation run(s);
  balanceOf(run, 1);
  EXPECT_LT(errorOfShadow(run.particles(), 0.113, 0.5 * 1000 * 0.05 * 0.05), 0.05);
  s.obstacles[0].until = 1e-9;  // the light returns
  Simulation later(s);
  const LedgerReport l = balanceOf(later, 3);
  EXPECT_NEAR(l.lamps.absorbed / later.w.clock.time, 500, 10);
}

TEST(Shadow, OfABodyHasItsEdgeWithinASpacing) {
  Scene s = block();
  addBox(s, {0.1, -0.5, 0.5}, {0.5, 0.5, 0.6});
  for (const bool tilted : {false, true}) {
    s.lamps = {sun({tilted ? -0.2 : 0, 0, -1})};
    Simulation run(s);
    balanceOf(run, 1);
    const double edge = 0.1 - (tilted ? 0.2 * 0.525 : 0);
    EXPECT_LT(errorOfShadow(run.particles(), edge, 0.5 * 1000 * 0.05 * 0.05), 0.05);
  }
}

TEST(HeatedRegion, SharesItsPowerByMass) {
  Scene s = block();
  HeatedRegion r;
  r.name = "coil";
  r.power = 300;
  r.shape = boxOf({-0.2, -0.2, -0.6}, {0.2, 0.2, 0.1});
  r.start = 0.001;
  s.heatedRegions = {r};
  s.numerics.fixedStep = 0.0008;
  Simulation run(s);
  const LedgerReport l = balanceOf(run, 5);
  EXPECT_NEAR(l.regions.given, 300 * (run.w.clock.time - 0.001), 1e-12);
  EXPECT_NEAR(l.regions.absorbed, l.regions.given, 1e-13);
  const Continuum& p = run.particles();
  for (std::size_t i = 0; i < p.owned; i++) {
    const bool in = std::abs(p.position[i].x) < 0.2 && std::abs(p.position[i].y) < 0.2;
    EXPECT_NEAR(static_cast<double>(p.absorbed[i]), in ? 300.0 / 640 : 0, 1e-6);
  }
}

TEST(HeatedRegion, MovesWithItsKeyframesAndWithoutParticlesGivesNothing) {
  Scene s = block();
  HeatedRegion r;
  r.name = "coil";
  r.power = 300;
  r.shape = boxOf({-0.2, -0.2, -0.6}, {0.2, 0.2, 0.1});
  r.motion = {{0, {}, {}}, {0.001, {0, 0, 1.5}, {}}};
  s.heatedRegions = {r};
  s.numerics.fixedStep = 0.0005;
  Simulation run(s);
  const LedgerReport l = balanceOf(run, 4);
  EXPECT_NEAR(l.regions.given, 300 * 0.002, 1e-12);
  EXPECT_NEAR(l.regions.absorbed, 300 * 0.0005, 1e-12);
}

TEST(HeatSources, MoveAtMostHalfASpacingInAStep) {
  Scene s = block();
  s.lasers = {laserAt({-0.4, 0, 0}, 0.01)};
  s.lasers[0].motion = {{0, {}, {}}, {1e-3, {0.8, 0, 0}, {}}};
  Simulation run(s);
  run.step();
  run.step();
  EXPECT_LE(run.w.clock.dt, 0.025 / 800 * (1 + 1e-12));
  EXPECT_EQ(run.limitedBy, Limit::Heat);
}

TEST(HeatSources, LimitTheStepInWhichTheyBeginToMove) {
  Scene s = block();
  s.lasers = {laserAt({-0.4, 0, 0}, 0.01)};
  s.lasers[0].motion = {{1, {}, {}}, {1.001, {0.8, 0, 0}, {}}, {3, {0.8, 0, 0}, {}}};
  EXPECT_NEAR(lightStepLimit(s, 0), 1 + 0.025 / 800, 1e-12);
  EXPECT_NEAR(lightStepLimit(s, 1.0005), 0.025 / 800, 1e-12);
  EXPECT_EQ(lightStepLimit(s, 1.001), never);
  s.lasers[0].end = 1;
  EXPECT_EQ(lightStepLimit(s, 0), never);
}

}  // namespace thaw::test
