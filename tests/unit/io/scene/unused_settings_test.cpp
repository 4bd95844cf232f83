// SPDX-License-Identifier: Apache-2.0
// Warnings of settings that have no effect in their scene.
#include <gtest/gtest.h>

#include "io/scene/read_scene.hpp"
#include "io/scene/scene_warnings.hpp"

namespace thaw {
namespace {

std::vector<std::string> warningsOf(const std::string& material, const std::string& tables) {
  return sceneWarnings(readScene(sceneFilesOf(
      "s.toml", "spacing = 0.1\nend = 1\n[material.m]\n" + material +
                    "\n[[body]]\nname = \"b\"\nmaterial = \"m\"\nbox = { size = [1, 1, 1] }\n" + tables)));
}

const std::string solid = "young = 1e6", liquid = "viscosity = 1";

TEST(UnusedSettings, OfSleepAndRigidMotionAreReported) {
  const auto line = [](const std::string& text) {
    return std::vector<std::string>{"s.toml: `numerics." + text};
  };
  EXPECT_EQ(warningsOf(liquid, "[numerics]\nsleep_speed = 0.01\n"),
            line("sleep_speed` has no effect in a scene without solids"));
  EXPECT_EQ(warningsOf(liquid, "[numerics]\nrigidify = 0.1\n"),
            line("rigidify` has no effect in a scene without solids"));
  EXPECT_EQ(warningsOf(solid, "[numerics]\nsleep_after = 0.1\n"),
            line("sleep_after` has no effect without `sleep_speed` or `rigidify`"));
  EXPECT_EQ(warningsOf(solid, "[numerics]\nrigidify = 0.1\nsleep_heating = 1\n"),
            line("sleep_heating` has no effect without `sleep_speed`"));
  EXPECT_TRUE(warningsOf(solid, "[numerics]\nsleep_speed = 0.01\nsleep_after = 0.1\n").empty());
  EXPECT_TRUE(warningsOf(solid, "[numerics]\nrigidify = 0.1\nsleep_after = 0.1\n").empty());
}

TEST(UnusedSettings, OfARigidLiquidAreReported) {
  EXPECT_EQ(warningsOf("law = \"rigid\"\nphase = \"liquid\"", ""),
            std::vector<std::string>{
                "s.toml:3:1: material 'm': `law = \"rigid\"` has no effect with `phase = \"liquid\"`"});
  EXPECT_TRUE(warningsOf("law = \"rigid\"", "").empty());
}

TEST(UnusedSettings, OfWeldsOfRigidWithElasticSolidsAreReported) {
  const std::string iron = "law = \"rigid\"\nweld_temperature = 1000",
                    jelly = "[material.jelly]\nyoung = 1e4\n",
                    body =
                        "[[body]]\nname = \"c\"\nmaterial = \"jelly\"\nbox = { size = [1, 1, 1] }\n"
                        "place = { move = [2, 0, 0] }\n";
  EXPECT_EQ(
      warningsOf(iron, jelly + "weld = true\n" + body),
      std::vector<std::string>{
          "s.toml:3:1: material 'm': `weld_temperature` joins its rigid pieces to each other only, not to "
          "elastic solids of 'jelly', whose `weld` joins elastic solids only"});
  EXPECT_TRUE(warningsOf(iron, jelly + body).empty());
  EXPECT_TRUE(warningsOf("law = \"rigid\"", jelly + "weld = true\n" + body).empty());
}

TEST(SceneWarnings, NameBuoyancyThatNothingBalances) {
  const auto scene = [](const std::string& sides) {
    return sceneWarnings(readScene(sceneFilesOf(
        "s.toml",
        "spacing = 0.1\nend = 1\n[domain]\nmin = [-0.5, -0.5, -0.5]\nmax = [0.5, 0.5, 0.5]\n"
        "gravity = [0, 0, -9.81]\nsides = " +
            sides +
            "\n[material.m]\nviscosity = 1\nexpansion = 1e-3\nconductivity = 1\nheat_capacity = 1\n"
            "[numerics]\nbuoyancy = \"boussinesq\"\n[[body]]\nname = \"b\"\nmaterial = \"m\"\n"
            "box = { size = [1, 1, 1] }\ntemperature = 300\ntemperature_gradient = [1, 0, 0]\n")));
  };
  const std::vector<std::string> lines = scene("{ x = \"periodic\", y = \"periodic\", z = \"periodic\" }");
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_NE(lines[0].find("the domain is periodic along gravity, so nothing balances"), std::string::npos);
  EXPECT_TRUE(scene("{ x = \"periodic\", y = \"periodic\", z = \"wall\" }").empty());
}

TEST(UnusedSettings, OfSprayWithoutASurfaceAreReported) {
  EXPECT_EQ(warningsOf(liquid, "[output]\nspray = \"hide\"\n"),
            std::vector<std::string>{"s.toml: `output.spray` has no effect without a table [surface]"});
  EXPECT_TRUE(warningsOf(liquid, "[output]\nspray = \"hide\"\n[surface]\n").empty());
}

}  // namespace
}  // namespace thaw
