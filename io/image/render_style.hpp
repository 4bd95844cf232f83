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
  Vec3f colour{1, 1, 1};             ///< linear light transmitted by four faces; reflection is separate
};

/// Distant light.
struct DistantLight {
  Vec3d direction{0, 0, 1};  ///< to the light, any length
  Vec3f colour{1, 1, 1};     ///< linear red, green, blue; 1: as bright as the default sun
  double size = 0.14;        ///< rad, angle that it subtends
};

/// Background and light of a picture.
struct Lighting {
  std::optional<Rgb> background;     ///< empty: a pale sky
  std::optional<Rgb> backgroundTop;  ///< high above the horizon; empty: as `background`
  std::optional<Vec3d> sun;  ///< direction to the sun, any length; empty: over the camera's left shoulder
  std::vector<DistantLight> lights;  ///< replace the sun; the first one makes highlights
  float ambient = 1;                 ///< strength of the sky's light
};

struct RenderStyle {
  int width = 1280, height = 960;  ///< pixels
  int samples = 2;                 ///< samples per pixel along each axis, 1 to 4
  Camera camera;                   ///< used as it is; fit it with fittedCamera
  ColourScale colours;
  float spacing = 0;  ///< m, particle spacing for surface normals; 0: from the radii
  std::vector<FloorHint> floors;
  std::vector<GlassHint> glasses;
  Lighting lighting;
  ViewBox stage;  ///< m, region of interest: floors fade away from it; empty: the particles
};

}  // namespace thaw
