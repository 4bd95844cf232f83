// SPDX-License-Identifier: Apache-2.0
// Background of a picture: sky, and floors with shadows.
#pragma once
#include <limits>
#include <vector>

#include "io/image/linear_light.hpp"
#include "io/render/light/lights.hpp"

namespace thaw {

class Backdrop {
 public:
  /// Keeps the floors that face the camera. `stage` as in RenderStyle; if that is empty, the box of the drawn
  /// objects.
  Backdrop(const RenderStyle& style, const View& view, const ViewBox& stage, const Lights& lights,
           const Discs& casters);

  /// Returns the nearest floor in front of `depth` along a ray (of depth 1) and sets `depth`; null: none.
  const FloorLight* floorBefore(const Vec3f& ray, float& depth) const;
  Light floorShade(const FloorLight& floor, const Vec3f& ray, float depth) const;
  Light sky(const Vec3f& ray) const;
  /// Returns the light of the floor below a point, as a fraction of that of an unshadowed floor. It is for
  /// reflection from below; 1 without a floor.
  float bounce(const Vec3f& point) const;
  const std::vector<FloorLight>& floors() const { return floors_; }

 private:
  const View& view_;
  float reach_ = 1;
  std::vector<FloorLight> floors_;
  const Light top_, low_, floor_, sun_;
  const float ambient_;
};

}  // namespace thaw
