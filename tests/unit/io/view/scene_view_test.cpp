// SPDX-License-Identifier: Apache-2.0
#include "io/view/run/scene_view.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/unit/io/lit_scene.hpp"

using namespace thaw;
using namespace thaw::test;

namespace {

nlohmann::ordered_json lightingOfView(const std::string& output) {
  return sceneView(sceneWithOutput(output))["lighting"];
}

TEST(SceneView, HasTheLightsOfPictures) {
  const auto lighting = lightingOfView(
      "background = \"#203040\"\nambient = 0.25\n[[output.light]]\ndirection = [3, 0, 4]\nstrength = 2\n"
      "colour = \"#ff0000\"\n[[output.light]]\ndirection = [0, 1, 0]\n");
  ASSERT_EQ(lighting["lights"].size(), 2u);
  EXPECT_DOUBLE_EQ(lighting["lights"][0]["to_light"][0], 0.6);
  EXPECT_DOUBLE_EQ(lighting["lights"][0]["to_light"][2], 0.8);
  EXPECT_DOUBLE_EQ(lighting["lights"][0]["colour"][0], 2);
  EXPECT_DOUBLE_EQ(lighting["lights"][0]["colour"][1], 0);
  EXPECT_DOUBLE_EQ(lighting["ambient"], 0.25);
  EXPECT_EQ(lighting["background"].dump(), "[32,48,64]");
  EXPECT_EQ(lighting["background_top"], lighting["background"]);
}

TEST(SceneView, HasNoLightsWithoutChoice) {
  EXPECT_TRUE(lightingOfView("")["lights"].empty());
  EXPECT_TRUE(lightingOfView("")["background"].is_null());
  EXPECT_EQ(lightingOfView("sun = [0, 0, 2]\n")["lights"][0]["to_light"].dump(), "[0.0,0.0,1.0]");
}

}  // namespace
