// The light of a picture: a sun over the camera's left shoulder that casts a soft shadow, and a sky that
// reaches what lies open to it.
#pragma once
#include <vector>

#include "io/render/depth_map.hpp"
#include "io/render/render.hpp"

namespace thaw {

struct Lights {
  DepthMap sun;
  std::vector<DepthMap> sky;  ///< from directions spread over the upper half of the sphere
  float radius = 0;           ///< m, typical of the particles
};

/// Unit vectors toward the light: where the sun stands in a picture, directions over its disc, which makes
/// shadows soft, and over the sky.
Vec3f sunDirection(const View& view);
std::vector<Vec3f> sunDisc(const Vec3f& toSun, int count);
std::vector<Vec3f> skyDome(int count);

Lights makeLights(const Discs& spheres, const View& view);

/// Light of the sky on a surface: 1 on one that faces up to an open sky. Some comes from below, off a floor.
float skyLight(const Lights& lights, const Vec3f& point, const Vec3f& normal);

/// Light of the sun, 0 to 1, on a surface. Taps as of DepthMap::visible.
float sunLight(const Lights& lights, const Vec3f& point, const Vec3f& normal, int taps);

/// Light on a floor around the stage, tabulated, as it varies slowly over a picture's samples.
class FloorLight {
 public:
  /// Shadows of `casters`: their outlines on the floor along many directions of the sun's disc and of the
  /// sky.
  FloorLight(const Lights& lights, const Discs& casters, const FloorHint& floor, const Vec3f& centre,
             float reach);
  /// Of the sun (with the angle of the floor to it) and of the sky, at a point of the floor.
  struct Light {
    float sun, sky;
  };
  Light at(const Vec3f& point) const;
  const Vec3f& normal() const { return normal_; }
  const Vec3f& origin() const { return origin_; }  ///< the stage's centre on the floor
  const Light& open() const { return open_; }      ///< far from all that casts shadows

 private:
  static constexpr int side_ = 512;
  Vec3f origin_, normal_, u_, v_;
  float reach_;
  Light open_;
  std::vector<Light> table_;  // side x side
};

}  // namespace thaw
