// SPDX-License-Identifier: Apache-2.0
// The check of a scene that a program has built or changed.
#pragma once
#include <string>

#include "core/scene/scene.hpp"

namespace thaw {

/// Checks values by the ranges of scene files, references to materials, and rules across tables.
/// name: the scene's, for messages without a place. Throws SceneErrors.
void checkBuiltScene(Scene scene, const std::string& name);

}  // namespace thaw
