// SPDX-License-Identifier: Apache-2.0
// Lighting of pictures: a sun over the camera's left shoulder with soft shadows, or the lights of a scene,
// and ambient light of the sky.
#pragma once
#include <vector>

#include "io/image/linear_light.hpp"
#include "io/image/render_style.hpp"
#include "io/render/light/depth_map.hpp"
#include "io/render/light/glass_walk.hpp"

namespace thaw {

/// A distant light: its direction, colour and angular radius (rad).
struct LightSource {
  Vec3f toLight{0, 0, 1};
  Light colour{1, 1, 1};
  float radius = 0.07f;
};

/// Returns the sun, or the lights that replace it. The first one is called the sun.
std::vector<LightSource> lightSources(const Lighting& lighting, const View& view);

/// Colours of a white surface in pictures of surfaces: in direct sunlight, and in the light of an open sky.
inline constexpr Light sunTint{0.88f, 0.86f, 0.82f}, skyTint{0.52f, 0.54f, 0.58f};

struct SideLight {
  LightSource source;
  std::vector<DepthMap> maps;  ///< maps from directions spread over its disc
  GlassShade glass{};
};

struct Lights {
  LightSource source;           ///< the sun
  float ambient = 1;            ///< strength of the light from the sky
  std::vector<SideLight> more;  ///< lights beside the sun
  DepthMap sun;
  std::vector<DepthMap> sky;  ///< from directions spread over the upper hemisphere
  float radius = 0;           ///< m, typical of the particles
  GlassShade glass{};         ///< in the light of the sun
};

/// Sets the shadows of the style's glasses.
void addGlasses(const RenderStyle& style, Lights& lights);

/// Return unit vectors toward the light: samples of the disc of a light (for soft shadows), and of the sky.
std::vector<Vec3f> lightDisc(const LightSource& light, int count);
std::vector<Vec3f> skyDome(int count);

Lights makeLights(const Discs& spheres, const RenderStyle& style, const View& view);

/// Returns the sky's light on a surface: 1 if it faces up to an open sky. A fraction is reflected from below.
float skyLight(const Lights& lights, const Vec3f& point, const Vec3f& normal);

/// Returns the light of a source, 0 to 1, on a surface. radius: m, of particles. taps: see DepthMap::visible.
float directLight(const DepthMap& map, float radius, const Vec3f& point, const Vec3f& normal, int taps);

/// Light on a floor around the stage, in a table.
class FloorLight {
 public:
  /// Computes shadows of `casters` from their outlines along many directions of the sun's disc and the sky.
  FloorLight(const Lights& lights, const Discs& casters, const FloorHint& floor, const Vec3f& centre,
             float reach);
  /// Light of the sun (with the angle of incidence) and of the sky, at a point of the floor.
  struct Light {
    float sun, sky;
    thaw::Light more{};          ///< from lights beside the sun
    thaw::Light glass{1, 1, 1};  ///< fraction of the sun's light that passes glass
  };
  Light at(const Vec3f& point) const;
  const Vec3f& normal() const { return normal_; }
  const Vec3f& origin() const { return origin_; }  ///< centre of the stage on the floor
  const Light& open() const { return open_; }      ///< without shadows

 private:
  /// Adds a light beside the sun. blocked: per cell, the light that casters hide.
  void addLight(const SideLight& light, const std::vector<float>& blocked);
  Vec3f pointOf(std::size_t cell) const;

  static constexpr int side_ = 512;
  Vec3f origin_, normal_, u_, v_;
  float reach_;
  Light open_;
  std::vector<Light> table_;  // side x side
};

}  // namespace thaw
