// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "io/scene/read_scene.hpp"

using namespace thaw;

TEST(SceneDocumentation, DocsSceneMdMatchesTheTableOfKeys) {
  std::ifstream file(THAW_SOURCE_DIR "/docs/scene.md");
  std::ostringstream text;
  text << file.rdbuf();
  EXPECT_TRUE(text.str() == sceneDocumentation())
      << "docs/scene.md is out of date; write it with: build/release/thaw docs > docs/scene.md";
}

TEST(SceneDocumentation, SchemaOfScenesMatchesTheTableOfKeys) {
  std::ifstream file(THAW_SOURCE_DIR "/scenes/scene.schema.json");
  std::ostringstream text;
  text << file.rdbuf();
  EXPECT_TRUE(text.str() == sceneSchema())
      << "it is out of date; write it with: build/release/thaw docs --schema > scenes/scene.schema.json";
}

TEST(SceneDocumentation, ExampleIsAValidScene) {
  const Scene s = readScene(sceneFilesOf("jelly.toml", exampleScene()));
  ASSERT_EQ(s.bodies.size(), 1u);
  EXPECT_GT(s.materials[0].young.solid, 0);
}
