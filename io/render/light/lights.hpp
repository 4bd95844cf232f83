// SPDX-License-Identifier: Apache-2.0
// Lighting of pictures: a sun over the camera's left shoulder with soft shadows, and ambient light of the
// sky.
#pragma once
#include <vector>

#include "io/image/render_style.hpp"
#include "io/render/light/depth_map.hpp"

namespace thaw {

struct Lights {
  DepthMap sun;
  std::vector<DepthMap> sky;  ///< from directions spread over the upper hemisphere
  float radius = 0;           ///< m, typical of the particles
};

/// Return unit vectors toward the light: the sun's direction, samples of its disc (for soft shadows), and of
/// the sky.
Vec3f sunDirection(const RenderStyle& style, const View& view);
std::vector<Vec3f> sunDisc(const Vec3f& toSun, int count);
std::vector<Vec3f> skyDome(int count);

Lights makeLights(const Discs& spheres, const Vec3f& toSun);

/// Returns the sky's light on a surface: 1 if it faces up to an open sky. A fraction is reflected from below.
float skyLight(const Lights& lights, const Vec3f& point, const Vec3f& normal);

/// Returns the sun's light, 0 to 1, on a surface. taps: see DepthMap::visible.
float sunLight(const Lights& lights, const Vec3f& point, const Vec3f& normal, int taps);

/// Light on a floor around the stage, in a table.
class FloorLight {
 public:
  /// Computes shadows of `casters` from their outlines along many directions of the sun's disc and the sky.
  FloorLight(const Lights& lights, const Discs& casters, const FloorHint& floor, const Vec3f& centre,
             float reach);
  /// Light of the sun (with the angle of incidence) and of the sky, at a point of the floor.
  struct Light {
    float sun, sky;
  };
  Light at(const Vec3f& point) const;
  const Vec3f& normal() const { return normal_; }
  const Vec3f& origin() const { return origin_; }  ///< centre of the stage on the floor
  const Light& open() const { return open_; }      ///< without shadows

 private:
  static constexpr int side_ = 512;
  Vec3f origin_, normal_, u_, v_;
  float reach_;
  Light open_;
  std::vector<Light> table_;  // side x side
};

}  // namespace thaw
