// SPDX-License-Identifier: Apache-2.0
// Rendering of particles as shaded spheres with a depth buffer, sun shadow, and sky light. Deterministic; one
// thread.
#pragma once
#include <span>

#include "core/math/vec3.hpp"
#include "io/image/image.hpp"
#include "io/image/render_style.hpp"

namespace thaw {

/// Particles to draw. Spans have one element per particle. radii may have one for all, and values may be
/// empty (then all are grey).
struct RenderInput {
  std::span<const Vec3f> positions;  ///< m
  std::span<const float> values;     ///< in the unit of the colour scale
  std::span<const float> radii;      ///< m
};

/// Draws the picture without text. Particles with non-finite positions are skipped. Throws
/// std::invalid_argument for invalid sizes of spans or picture.
Image render(const RenderInput& input, const RenderStyle& style);

}  // namespace thaw
