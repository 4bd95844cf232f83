// SPDX-License-Identifier: Apache-2.0
// Lights and background that a scene states.
#include <gtest/gtest.h>

#include "io/render/scene_job.hpp"
#include "tests/unit/io/lit_scene.hpp"

using namespace thaw;
using namespace thaw::test;

TEST(SceneLights, PicturesHaveTheLightsOfTheScene) {
  const Lighting all = lightingOf(sceneWithOutput("background = \"#203040\"\nbackground_top = \"#000000\"\n"
                                                  "ambient = 0.25\n[[output.light]]\ndirection = [1, 0, 1]\n"
                                                  "colour = \"#ff0000\"\nstrength = 2\nsize = \"2 deg\"\n"
                                                  "[[output.light]]\ndirection = [0, 1, 0]\n")
                                      .output);
  ASSERT_EQ(all.lights.size(), 2u);
  EXPECT_FLOAT_EQ(all.lights[0].colour.x, 2);
  EXPECT_FLOAT_EQ(all.lights[0].colour.y, 0);
  EXPECT_NEAR(all.lights[0].size, 0.0349, 1e-4);
  EXPECT_FLOAT_EQ(all.lights[1].colour.y, 1);
  EXPECT_FLOAT_EQ(all.ambient, 0.25f);
  EXPECT_TRUE(all.background && all.backgroundTop);
}

TEST(SceneLights, BadLightsAreRefused) {
  for (const char* output :
       {"sun = [0, 0, 1]\n[[output.light]]\ndirection = [1, 0, 1]\n", "[[output.light]]\nstrength = 1\n",
        "[[output.light]]\ndirection = [0, 0, 0]\n", "background_top = \"#000000\"\n"})
    EXPECT_THROW(sceneWithOutput(output), SceneErrors) << output;
}
