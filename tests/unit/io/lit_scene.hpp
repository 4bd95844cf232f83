// SPDX-License-Identifier: Apache-2.0
// A small scene with given lines of its table [output], for tests of lights and backgrounds.
#pragma once
#include <string>

#include "io/scene/read_scene.hpp"

namespace thaw::test {

inline Scene sceneWithOutput(const std::string& output) {
  SceneFiles files;
  files.main = "lit.toml";
  files.texts[files.main] =
      "spacing = 0.1\n[material.water]\n[[body]]\nbox = { size = [1, 1, 1] }\n"
      "material = \"water\"\n[output]\n" +
      output;
  return readScene(files, {});
}

}  // namespace thaw::test
