// What stands behind the bodies of a picture: the sky, and floors with the shadow on them.
#pragma once
#include <limits>
#include <vector>

#include "io/render/lights.hpp"
#include "io/render/linear_light.hpp"

namespace thaw {

class Backdrop {
 public:
  /// Floors that are seen from their front; `stage` as of RenderStyle, the box of what is drawn if that is
  /// empty.
  Backdrop(const RenderStyle& style, const View& view, const ViewBox& stage, const Lights& lights,
           const Discs& casters);

  /// Depth of the nearest floor in front of `depth` along a ray (of depth 1), and which; null: none.
  const FloorLight* floorBefore(const Vec3f& ray, float& depth) const;
  Light floorShade(const FloorLight& floor, const Vec3f& ray, float depth) const;
  Light sky(const Vec3f& ray) const;
  /// Light of the floor below a point over that of an open one: what comes from below to a surface there. 1
  /// where there is no floor.
  float bounce(const Vec3f& point) const;
  const std::vector<FloorLight>& floors() const { return floors_; }

 private:
  const View& view_;
  float reach_ = 1;
  std::vector<FloorLight> floors_;
  const Light top_, low_, floor_;
};

}  // namespace thaw
