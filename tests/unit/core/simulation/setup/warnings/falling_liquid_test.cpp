// SPDX-License-Identifier: Apache-2.0
// Liquid that falls out of the domain is reported, with the time.
#include <gtest/gtest.h>

#include "tests/support/simulation.hpp"

namespace thaw::test {
namespace {

constexpr double h = 0.01;

/// A cube of water whose lower side is 0.2 m above the open low z side.
Scene fallingCube() {
  Scene s;
  s.spacing = h;
  s.end = 1;
  s.domain.min = {-0.2, -0.2, 0};
  s.domain.max = {0.2, 0.2, 0.4};
  s.materials.resize(1);
  Body cube;
  cube.name = "cube";
  cube.where = {"cube.toml", 7, 1};
  cube.shape = boxOf({-0.03, -0.03, 0.2}, {0.03, 0.03, 0.26});
  s.bodies.push_back(cube);
  return s;
}

Obstacle plate(const Vec3d& low, const Vec3d& high) {
  Obstacle o;
  o.shape = boxOf(low, high);
  return o;
}

std::string fallWarning(const Scene& s) {
  const Simulation run(s);
  for (const SceneWarning& w : run.report.warnings)
    if (w.text.find("falls out of the domain") != std::string::npos) return w.where.file + " " + w.text;
  return "";
}

}  // namespace

TEST(FallingLiquid, IsReportedWithTheTimeOfItsFall) {
  const std::string text = fallWarning(fallingCube());
  EXPECT_EQ(text.find("cube.toml body 'cube' falls out"), 0u) << text;
  EXPECT_NE(text.find("the low z side is open"), std::string::npos) << text;
  EXPECT_NE(text.find("leave at 0.2 s"), std::string::npos) << text;  // sqrt(2 * 0.2 m / g) = 0.202 s
}

TEST(FallingLiquid, IsReportedUnlessAllIsAboveObstaclesInItsWay) {
  Scene s = fallingCube();
  s.obstacles.push_back(plate({0.1, -0.2, 0.05}, {0.2, 0.2, 0.055}));
  EXPECT_NE(fallWarning(s), "") << "the plate is beside the path";
  s.bodies[0].velocity = {1, 0, 0};
  EXPECT_EQ(fallWarning(s), "") << "the water flies to the plate";
  s = fallingCube();
  s.obstacles.push_back(plate({-0.2, -0.2, 0.05}, {0.2, 0.2, 0.055}));
  EXPECT_EQ(fallWarning(s), "");
  s.obstacles[0].until = 0.05;
  EXPECT_NE(fallWarning(s), "") << "the plate vanishes before";
}

TEST(FallingLiquid, IsNotReportedAboveASolidBody) {
  Scene s = fallingCube();
  s.materials.push_back({});
  s.materials[1].young = {1e5, 0};
  Body block = s.bodies[0];
  block.name = "block";
  block.material = 1;
  block.shape = boxOf({-0.05, -0.05, 0.05}, {0.05, 0.05, 0.1});
  s.bodies.push_back(block);
  EXPECT_EQ(fallWarning(s), "");
}

TEST(FallingLiquid, IsNotReportedWithoutAnOpenSideBelowOrWithoutGravity) {
  Scene s = fallingCube();
  s.domain.side[2] = {Side::Wall, Side::Open};
  EXPECT_EQ(fallWarning(s), "");
  s.domain.side[2] = {Side::Periodic, Side::Periodic};
  EXPECT_EQ(fallWarning(s), "");
  s = fallingCube();
  s.domain.gravity = {};
  EXPECT_EQ(fallWarning(s), "");
  s = fallingCube();
  s.end = 0.15;
  EXPECT_EQ(fallWarning(s), "") << "the scene ends before";
  s = fallingCube();
  s.domain.gravity = {0, 9.81, 0};
  EXPECT_NE(fallWarning(s).find("the high y side is open"), std::string::npos);
}

TEST(FallingLiquid, OfAnEmitterIsReported) {
  Scene s = fallingCube();
  s.bodies.clear();
  Emitter tap;
  tap.name = "tap";
  tap.radius = 0.02;
  tap.centre = {0, 0, 0.2};
  tap.start = 0.25;
  s.emitters.push_back(tap);
  const std::string text = fallWarning(s);  // 0.25 s + 0.124 s at 1 m/s downwards
  EXPECT_NE(text.find("emitter 'tap' falls out of the domain"), std::string::npos) << text;
  EXPECT_NE(text.find("leave at 0.3"), std::string::npos) << text;
  s.obstacles.push_back(plate({-0.2, -0.2, 0.05}, {0.2, 0.2, 0.055}));
  EXPECT_EQ(fallWarning(s), "");
}

}  // namespace thaw::test
