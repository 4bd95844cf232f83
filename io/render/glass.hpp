// Clear solid things over a picture: their surfaces found by walking along the view rays through signed
// distances.
#pragma once
#include "io/render/render.hpp"
#include "io/render/splat.hpp"

namespace thaw {

/// Mixes the glasses of the style into the picture, before what lies nearer..
void drawGlasses(Image& image, const RenderStyle& style, const View& view, const DepthBuffer& buffer);

}  // namespace thaw
