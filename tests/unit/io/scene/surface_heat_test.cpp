// SPDX-License-Identifier: Apache-2.0
// Convection and radiation need a support radius that separates surface from inside.
#include <gtest/gtest.h>

#include "io/scene/read_scene.hpp"

namespace thaw {
namespace {

Scene sceneOf(const std::string& numerics, const std::string& material) {
  SceneFiles files;
  files.main = "test.toml";
  files.texts["test.toml"] = "spacing = 0.1\nend = 1\n[numerics]\n" + numerics +
                             "\n[material.oil]\nconductivity = 1\n" + material +
                             "\n[[body]]\nname = 'all'\nmaterial = 'oil'\nbox = { size = [1, 1, 1] }\n";
  return readScene(files);
}

}  // namespace

TEST(SurfaceHeat, NeedsASupportOfTwo) {
  EXPECT_THROW(sceneOf("support = 1.8", "convection = 10"), SceneErrors);
  EXPECT_THROW(sceneOf("support = 1.8", "emissivity = 0.5"), SceneErrors);
  EXPECT_NO_THROW(sceneOf("support = 1.8", ""));
  EXPECT_NO_THROW(sceneOf("support = 2", "convection = 10"));
}

}  // namespace thaw
