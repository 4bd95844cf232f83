// SPDX-License-Identifier: Apache-2.0
// Rendering of particles as shaded spheres with a depth buffer, sun shadow, and sky light. Deterministic; one
// thread.
#pragma once
#include <memory>
#include <span>
#include <vector>

#include "core/geometry/basic/signed_distance.hpp"
#include "core/math/mat3.hpp"
#include "io/render/image/colour_map.hpp"
#include "io/render/image/image.hpp"
#include "io/render/image/view.hpp"

namespace thaw {

/// Particles to draw. Spans have one element per particle; radii may have one for all, and values may be
/// empty (then all are grey).
struct RenderInput {
  std::span<const Vec3f> positions;  ///< m
  std::span<const float> values;     ///< in the unit of the colour scale
  std::span<const float> radii;      ///< m
};

/// Plane of the scene, drawn as a floor with shadow if its front (the side of the normal) faces the camera.
struct FloorHint {
  Vec3d point{}, normal{0, 0, 1};  ///< m; unit vector
};

/// Solid object drawn as clear glass.
struct GlassHint {
  std::shared_ptr<const SignedDistance> shape;
  Mat3d turn = identity3<double>();  ///< pose: x = move + turn x_shape
  Vec3d move{};                      ///< m
};

struct RenderStyle {
  int width = 1280, height = 960;  ///< pixels
  int samples = 2;                 ///< samples per pixel along each axis, 1 to 4
  Camera camera;                   ///< used as it is; fit it with fittedCamera
  ColourScale colours;
  float spacing = 0;  ///< m, particle spacing for surface normals; 0: from the radii
  std::vector<FloorHint> floors;
  std::vector<GlassHint> glasses;
  ViewBox stage;  ///< m, region of interest: floors fade away from it; empty: the particles
};

/// Draws the picture without text. Particles with non-finite positions are skipped. Throws
/// std::invalid_argument for invalid sizes of spans or picture.
Image render(const RenderInput& input, const RenderStyle& style);

}  // namespace thaw
