// SPDX-License-Identifier: Apache-2.0
// Warnings about a scene.
#pragma once
#include <string>

#include "core/scene/shape.hpp"

namespace thaw {

/// Warning about the scene, with its source location.
struct SceneWarning {
  SourcePlace where;
  std::string text;
};

}  // namespace thaw
