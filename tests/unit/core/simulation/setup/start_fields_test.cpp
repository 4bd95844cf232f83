// SPDX-License-Identifier: Apache-2.0
// Initial velocities and temperatures that vary with position; the automatic sound speed.
#include <gtest/gtest.h>

#include "core/geometry/basic/shape_error.hpp"
#include "core/materials/liquid_materials.hpp"
#include "core/scene/expected_speeds.hpp"
#include "core/simulation/setup/start_fields.hpp"
#include "core/terms/find_modules.hpp"
#include "tests/support/simulation.hpp"

namespace thaw::test {
namespace {

PositionField fieldOf(const char* key, std::function<double(const Vec3d&)> value) {
  return {"f(x, y, z)", key, {"fields.toml", 7, 3}, std::move(value)};
}

/// Water in a box of 1 m edges around `middle`, 20 spacings per side, without gravity.
Scene waterBox(const Vec3d& middle = {}) {
  Scene s;
  s.spacing = 0.1;
  s.domain.min = {-2, -2, -2};
  s.domain.max = {2, 2, 2};
  s.domain.gravity = {};
  s.materials.emplace_back();
  s.materials[0].name = "water";
  Body b;
  b.name = "box";
  b.shape.move = middle;
  s.bodies.push_back(b);
  return s;
}

double speedOf(const Scene& s) {
  Simulation run(s);
  return expectedFlow(run.w.scene).speed;
}

std::string whyOf(const Scene& s) {
  Simulation run(s);
  return soundSpeedReason(run.w.scene, run.w.scene.materials[0]);
}

std::string errorOf(const Scene& s) {
  try {
    Simulation run(s);
  } catch (const ShapeError& e) { return e.what(); }
  return "";
}

}  // namespace

TEST(StartFields, ParticlesHaveTheLinearFieldOnTopOfVelocityAndSpin) {
  Scene s = waterBox({0.3, 0, 0});
  s.bodies[0].velocity = {1, 0, 0};
  s.bodies[0].spin = {0, 0, 2};
  s.bodies[0].velocityField.linear = true;
  s.bodies[0].velocityField.gradient = {{{-3, 0, 0}, {0, 3, 0.5}, {0, 0, 0}}};
  Simulation run(s);
  ASSERT_EQ(run.particles().owned, 1000u);
  for (std::size_t i = 0; i < run.particles().owned; i++) {
    const Vec3d r = run.particles().position[i] - Vec3d{0.3, 0, 0}, v = run.particles().velocity[i];
    EXPECT_NEAR(v.x, 1 - 2 * r.y - 3 * r.x, 1e-12);
    EXPECT_NEAR(v.y, 2 * r.x + 3 * r.y + 0.5 * r.z, 1e-12);
    EXPECT_EQ(v.z, 0);
  }
}

TEST(StartFields, ExpressionsUseScenePositions) {
  Scene s = waterBox({0.3, 0, 0});
  s.bodies[0].velocityField.component[1] = fieldOf("body.box.velocity.y",
                                                   [](const Vec3d& x) { return x.x * x.z; });
  Simulation run(s);
  for (std::size_t i = 0; i < run.particles().owned; i++) {
    const Vec3d x = run.particles().position[i];
    EXPECT_DOUBLE_EQ(run.particles().velocity[i].y, x.x * x.z);
    EXPECT_EQ(run.particles().velocity[i].x, 0);
  }
}

// Its box is 10.5 spacings wide and has 10 layers of liquid.
TEST(StartFields, ExpectedSpeedIsThatOfTheFastestParticle) {
  Scene s = waterBox();
  s.bodies[0].shape.size = {1.05, 1.05, 1.05};
  s.bodies[0].velocityField.component[0] = fieldOf("body.box.velocity.x",
                                                   [](const Vec3d& x) { return 10 * x.x; });
  Simulation run(s);
  double fastest = 0;
  for (std::size_t i = 0; i < run.particles().owned; i++)
    fastest = std::max(fastest, length(run.particles().velocity[i]));
  EXPECT_DOUBLE_EQ(expectedFlow(run.w.scene).speed, fastest);
}

TEST(StartFields, RelaxedAndWrappedParticlesHaveTheFieldOfTheirPosition) {
  Scene s = waterBox({1.8, 0, 0});  // reaches over the side at x = 2
  s.domain.side[0][0] = s.domain.side[0][1] = Side::Periodic;
  s.bodies[0].packing = Packing::Relaxed;
  s.bodies[0].spin = {0, 0, 1};
  s.bodies[0].velocityField.component[2] = fieldOf("body.box.velocity.z",
                                                   [](const Vec3d& x) { return 10 * x.x; });
  Simulation run(s);
  int across = 0;
  for (std::size_t i = 0; i < run.particles().owned; i++) {
    Vec3d x = run.particles().position[i];
    if (x.x < 0) x.x += 4, across++;
    EXPECT_NEAR(run.particles().velocity[i].z, 10 * x.x, 1e-9);
    EXPECT_NEAR(run.particles().velocity[i].y, x.x - 1.8, 1e-9);
  }
  EXPECT_GT(across, 100);
}

TEST(StartFields, ATemperatureFieldSwitchesHeatOnAndDecidesAboutPhases) {
  Scene s = waterBox();
  s.bodies[0].temperatureField = fieldOf("body.box.temperature",
                                         [](const Vec3d& x) { return 300 + 100 * x.z; });
  EXPECT_FALSE(modulesOf(s).heat) << "nothing conducts";
  s.materials[0].conductivity = {1, 1};
  {
    Simulation run(s);
    ASSERT_TRUE(run.w.modules.heat);
    for (std::size_t i = 0; i < run.particles().owned; i++)
      EXPECT_NEAR(run.particles().temperature[i], 300 + 100 * run.particles().position[i].z, 1e-9);
  }
  s.materials[0].young = {1e5, 0};
  s.materials[0].solidus = 299;
  s.materials[0].liquidus = 301;
  Simulation run(s);
  for (std::size_t i = 0; i < run.particles().owned; i++)
    EXPECT_EQ(run.particles().phase[i] == Liquid, run.particles().position[i].z > 0);
}

TEST(StartFields, InvalidValuesAreErrorsWithTheirPlace) {
  Scene s = waterBox();
  s.bodies[0].velocityField.component[0] = fieldOf("body.box.velocity.x", [](const Vec3d& x) {
    return x.x < -0.4 && x.y < -0.4 && x.z < -0.3 ? NAN : 1.0;
  });
  EXPECT_EQ(errorOf(s),
            "fields.toml:7:3: error: body.box.velocity.x: \"f(x, y, z)\" is nan at (-0.45, -0.45, -0.45), a "
            "particle (2 in all); expected velocity components of at most 299792458 m/s (speed of light)");
  s.bodies[0].velocityField.component[0] = fieldOf("body.box.velocity.x",
                                                   [](const Vec3d& x) { return 1e300 * x.x; });
  EXPECT_NE(errorOf(s).find("is -4.5e+299 at (-0.45, -0.45, -0.45), a particle"), std::string::npos)
      << errorOf(s);
  s = waterBox();
  s.materials[0].conductivity = {1, 1};
  s.bodies[0].temperatureField = fieldOf("body.box.temperature",
                                         [](const Vec3d& x) { return 40 - 100 * x.z; });
  EXPECT_NE(errorOf(s).find(
                "is -5 at (-0.45, -0.45, 0.45), a particle (100 in all); expected temperatures above 0"),
            std::string::npos)
      << errorOf(s);
}

namespace {

/// An upward jet out of a disc of 0.25 m at the border of the domain.
Scene jet() {
  Scene s = waterBox();
  s.bodies.clear();
  s.spacing = 0.05;
  Emitter e;
  e.name = "jet";
  e.radius = 0.25;
  e.direction = {0, 0, 1};
  e.speed = 2;
  s.emitters.push_back(e);
  s.end = 0.2;
  return s;
}

}  // namespace

TEST(StartFields, EmitterFieldsVaryWithPosition) {
  Scene s = jet();
  s.materials[0].conductivity = {1e-9, 1e-9};
  s.emitters[0].velocityField.linear = true;
  s.emitters[0].velocityField.gradient = {{{0, -2, 0}, {2, 0, 0}, {0, 0, 0}}};
  s.emitters[0].temperatureField = fieldOf("emitter.jet.temperature",
                                           [](const Vec3d& x) { return 300 + 100 * x.x; });
  Simulation run(s);
  ASSERT_TRUE(run.w.modules.heat);
  ASSERT_GT(run.particles().owned, 100u);
  for (std::size_t i = 0; i < run.particles().owned; i++) {
    const Vec3d x = run.particles().position[i], v = run.particles().velocity[i];
    const Vec3d opening = x - v * (x.z / 2);  // position in the opening
    EXPECT_NEAR(v.x, -2 * opening.y, 1e-9);
    EXPECT_NEAR(v.y, 2 * opening.x, 1e-9);
    EXPECT_EQ(v.z, 2);
    EXPECT_NEAR(run.particles().temperature[i], 300 + 100 * opening.x, 1e-6);
  }
  EXPECT_TRUE(run.run());
  EXPECT_LT(std::abs(run.ledgerReport().energyResidual), 0.02 * run.ledgerReport().energyScale);
}

TEST(StartFields, EmitterRefusesAProfileAndASpreadInItsNozzle) {
  Scene s = jet();
  s.emitters[0].velocityField.component[2] = fieldOf("emitter.jet.velocity.z",
                                                     [](const Vec3d& x) { return x.x; });
  EXPECT_NE(errorOf(s).find("fields.toml:7:3: error: emitter 'jet': its velocity field has"),
            std::string::npos)
      << errorOf(s);
  s = jet();
  s.emitters[0].velocityField.component[0] = fieldOf("emitter.jet.velocity.x",
                                                     [](const Vec3d& x) { return 10 * x.x; });
  EXPECT_NE(errorOf(s).find("shears the liquid in the nozzle by"), std::string::npos) << errorOf(s);
  s = jet();
  s.emitters[0].temperatureField = fieldOf("emitter.jet.temperature", [](const Vec3d&) { return -1.0; });
  EXPECT_NE(errorOf(s).find("in the opening; expected temperatures above 0"), std::string::npos)
      << errorOf(s);
}

TEST(ExpectedSpeed, CountsTheFastestParticleOfSpinsAndFields) {
  Scene s = waterBox({0.5, 0, 0});
  s.bodies[0].spin = {0, 0, 5};
  EXPECT_NEAR(speedOf(s), 5 * 0.45 * std::sqrt(2), 1e-9);
  EXPECT_NE(whyOf(s).find("10 times 3.18 m/s, from the start of body 'box' (3.18 m/s)"), std::string::npos)
      << whyOf(s);
  s.bodies[0].spin = {};
  s.bodies[0].velocityField.linear = true;
  s.bodies[0].velocityField.gradient = {{{-100, 0, 0}, {0, 100, 0}, {0, 0, 0}}};
  EXPECT_NEAR(speedOf(s), 100 * 0.45 * std::sqrt(2), 1e-9);
  s.bodies[0].velocityField = {};
  s.bodies[0].velocityField.component[0] = fieldOf("", [](const Vec3d& x) { return 10 * x.x; });
  EXPECT_NEAR(speedOf(s), 9.5, 1e-9);
}

TEST(ExpectedSpeed, CountsFallsAndFilledColumnsOfEmitters) {
  Scene s = jet();
  s.domain.gravity = {0, 0, -10};
  s.emitters[0].direction = {0, 0, -1};
  EXPECT_NEAR(speedOf(s), std::sqrt(4 + 2 * 10 * 2), 1e-9);
  s.emitters[0].centre.z = -1.9;
  EXPECT_NEAR(speedOf(s), std::sqrt(4 + 2 * 10 * 0.1), 1e-9);
  s.emitters[0].direction = {0, 0, 1};  // may fill the domain, 4 m high
  EXPECT_NEAR(speedOf(s), std::sqrt(10 * 4.0), 1e-9);
  EXPECT_NE(whyOf(s).find("a column of 4 m that an emitter can fill"), std::string::npos) << whyOf(s);
  s.emitters[0].end = 0.5;
  EXPECT_NEAR(speedOf(s), std::sqrt(10 * 1.1), 1e-9);
}

TEST(ExpectedSpeed, IsEnoughForTheColumnOfABody) {
  Scene s = waterBox({0, 0, -1.5});
  s.domain.gravity = {0, 0, -10};
  const double v = speedOf(s), height = 1;
  EXPECT_NEAR(v, std::sqrt(2 * 10 * height), 1e-9);
  EXPECT_LE(10 * height / (v * v / s.numerics.maxDensityError), s.numerics.maxDensityError);  // g H / c^2
}

TEST(ExpectedSpeed, CountsMovingTurningAndLiftingObstacles) {
  Scene s = waterBox();
  Obstacle o;
  o.name = "mixer";
  o.shape.size = {0.2, 0.2, 0.2};
  o.shape.move = {1.5, 0, 0};
  o.motion = {{0, {}, {}}, {1, {0, 0, -3}, {}}};
  s.obstacles.push_back(o);
  EXPECT_NEAR(speedOf(s), 3, 1e-9);
  s.obstacles[0].motion = {{0, {}, {}}, {1, {}, {0, 0, 2}}};  // 2 rad/s about z through the origin; its far
                                                              // edge is at 1.6 m
  EXPECT_NEAR(speedOf(s), 2 * std::hypot(1.6, 0.1), 1e-6);
  EXPECT_NE(whyOf(s).find("obstacle 'mixer' (3.21 m/s)"), std::string::npos) << whyOf(s);
  s.obstacles[0].until = 0;
  EXPECT_LT(speedOf(s), 1e-9);
  s.obstacles[0].until = never;
  s.obstacles[0].motion = {{0, {}, {}}, {10, {0, 0, 0.5}, {}}};  // a lift of 0.5 m at 0.05 m/s
  s.domain.gravity = {0, 0, -10};
  EXPECT_NEAR(speedOf(s), std::hypot(0.05, std::sqrt(2 * 10 * 3.0)),
              1e-6);  // the box is 2.5 m above the bottom of the domain
}

TEST(ExpectedSpeed, CountsTensionIfFaster) {
  Scene s = waterBox();
  s.materials[0].surfaceTension = 5000;
  Simulation run(s);
  EXPECT_NEAR(run.tools.liquids[0].soundSpeed, 10 * std::sqrt(2 * 5000 / (1000 * 0.1)), 1e-9);
  EXPECT_NE(whyOf(s).find("from surface tension at one spacing"), std::string::npos) << whyOf(s);
}

}  // namespace thaw::test
