// SPDX-License-Identifier: Apache-2.0
// Rays through glass obstacles, by marching through signed distances.
#pragma once
#include <vector>

#include "io/image/linear_light.hpp"
#include "io/image/render_style.hpp"

namespace thaw {

/// Glass along a ray.
struct GlassLayer {
  double alpha = 0, bright = 0;  ///< opacity, 0 to 1, and brightness of its reflection
  int faces = 0;                 ///< crossed by the ray
};

/// A glass at its pose.
class GlassWalk {
 public:
  /// Requires: a bounded shape.
  explicit GlassWalk(const GlassHint& glass);
  /// Returns the glass between `origin` (m) and `origin + reach * direction`. Reflection grows at grazing
  /// angles (S94).
  GlassLayer along(const Vec3d& origin, const Vec3d& direction, double reach) const;
  /// Returns the fraction of light transmitted by this number of faces, without losses by reflection.
  Light tintOf(int faces) const;
  const Vec3d& centre() const { return centre_; }  ///< m, of a sphere around the glass
  double radius() const { return radius_; }        ///< m, of this sphere

 private:
  GlassLayer walk(const Vec3d& origin, const Vec3d& direction, double from, double to) const;
  GlassHint glass_;
  Bounds box_;  // m, around the shape; rays start outside of the surface
  Mat3d back_;
  Vec3d up_, centre_;
  double step_, radius_;
};

/// Returns the bounded glasses.
std::vector<GlassWalk> glassWalks(const RenderStyle& style);

/// Light of a distant source behind glasses.
class GlassShade {
 public:
  GlassShade() = default;
  /// directions: unit, over the source's disc. spread: rad, radius of the disc.
  GlassShade(const std::vector<GlassWalk>& glasses, const std::vector<Vec3f>& directions, float spread);
  bool empty() const { return glasses_.empty(); }
  /// Returns the fractions of red, green and blue that arrive at a point: 1 beside all shadows.
  Light at(const Vec3f& point) const;

 private:
  std::vector<GlassWalk> glasses_;
  std::vector<Vec3f> directions_;
  Vec3d middle_{};
  double spread_ = 0;
};

}  // namespace thaw
