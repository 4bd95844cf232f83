// SPDX-License-Identifier: Apache-2.0
// Glass obstacles over a picture, found by ray marching through signed distances.
#pragma once
#include "io/render/particles/render.hpp"
#include "io/render/particles/splat.hpp"

namespace thaw {

/// Draws the glasses of the style over the picture, in front of farther objects.
void drawGlasses(Image& image, const RenderStyle& style, const View& view, const DepthBuffer& buffer);

}  // namespace thaw
