// What a scene says about its pictures.
#pragma once
#include "core/scene/scene.hpp"
#include "io/render/render_frames.hpp"

namespace thaw {

/// Title, field and range of the colours, camera (unless it is to be fitted), size, spacing and walls of the scene's pictures.
/// Throws what makeSignedDistance throws for shapes that cannot be used.
FrameJob jobOfScene(const Scene& scene);

}  // namespace thaw
