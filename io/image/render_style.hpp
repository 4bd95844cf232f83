// SPDX-License-Identifier: Apache-2.0
// Settings of a picture.
#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "core/geometry/basic/signed_distance.hpp"
#include "core/math/mat3.hpp"
#include "io/image/colour_map.hpp"
#include "io/image/image.hpp"
#include "io/image/view.hpp"

namespace thaw {

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
  std::optional<Rgb> background;  ///< empty: a pale sky
  std::optional<Vec3d> sun;  ///< direction to the sun, any length; empty: over the camera's left shoulder
  ViewBox stage;             ///< m, region of interest: floors fade away from it; empty: the particles
};

}  // namespace thaw
