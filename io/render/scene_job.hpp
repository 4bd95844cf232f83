// What a scene says about its pictures, and the scene that a frame was made from.
#pragma once
#include <string>

#include "core/scene/scene.hpp"
#include "io/render/render_frames.hpp"

namespace thaw {

/// Title, field and range of the colours, camera (unless it is to be fitted), size, spacing and walls of the
/// scene's pictures. Throws what makeSignedDistance throws for shapes that cannot be used.
FrameJob jobOfScene(const Scene& scene);

/// The scene from the text that its run keeps in frames (Scene::text: all files, then the overrides) and the
/// stem of the scene file's name. Throws SceneErrors, also if the text is not of that kind.
Scene sceneOfText(const std::string& text, const std::string& name);

}  // namespace thaw
