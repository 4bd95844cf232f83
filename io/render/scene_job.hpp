// SPDX-License-Identifier: Apache-2.0
// Picture settings of a scene, and the scene of a frame.
#pragma once
#include <string>

#include "core/scene/scene.hpp"
#include "io/render/render_frames.hpp"

namespace thaw {

/// Returns the background and the lights of a scene's pictures.
Lighting lightingOf(const Output& output);

/// Returns title, field and range of colours, camera (unless fitted), size, spray, spacing and walls of the
/// scene's pictures. Throws like makeSignedDistance for invalid shapes.
FrameJob jobOfScene(const Scene& scene);

/// Parses the scene from the text that its run stores in frames (Scene::text: all files, then the overrides).
/// name: stem of the scene file's name. Throws SceneErrors, also for other text.
Scene sceneOfText(const std::string& text, const std::string& name);

}  // namespace thaw
