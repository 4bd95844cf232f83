// SPDX-License-Identifier: Apache-2.0
#include "io/render/light/backdrop.hpp"

#include <algorithm>
#include <cmath>

namespace thaw {

namespace {

constexpr Rgb skyTop{232, 236, 241}, skyLow{205, 211, 218}, floorColour{206, 206, 204};

Rgb topOf(const Lighting& lighting) {
  return lighting.backgroundTop.value_or(lighting.background.value_or(skyTop));
}
float brightness(const Light& l) { return (l.x + l.y + l.z) / 3; }

}  // namespace

Backdrop::Backdrop(const RenderStyle& style, const View& view, const ViewBox& stage, const Lights& lights,
                   const Discs& casters)
    : view_(view),
      top_(toLinear(topOf(style.lighting))),
      low_(toLinear(style.lighting.background.value_or(skyLow))),
      floor_(toLinear(style.lighting.background.value_or(floorColour))),
      sun_(lights.source.colour),
      ambient_(lights.ambient) {
  const Vec3d c = stage.empty() ? Vec3d{} : stage.centre();
  const Vec3f centre{static_cast<float>(c.x), static_cast<float>(c.y), static_cast<float>(c.z)};
  reach_ = stage.empty() ? 1 : std::max(static_cast<float>(0.5 * length(stage.max - stage.min)), 1e-6f);
  for (const FloorHint& floor : style.floors) {
    const Vec3d from{view.origin.x, view.origin.y, view.origin.z};
    if (dot(from - floor.point, floor.normal) > 0)
      floors_.emplace_back(lights, casters, floor, centre, 2.2f * reach_);
  }
}

const FloorLight* Backdrop::floorBefore(const Vec3f& ray, float& depth) const {
  const FloorLight* floor = nullptr;
  for (const FloorLight& f : floors_) {
    const float down = -dot(ray, f.normal());
    if (down <= 1e-6f) continue;
    const float t = dot(view_.origin - f.origin(), f.normal()) / down;
    if (t < depth) depth = t, floor = &f;
  }
  return floor;
}

Light Backdrop::sky(const Vec3f& ray) const {
  const float up = ray.z / std::sqrt(dot(ray, ray));
  return mixed(low_, top_, ramp(-0.05f, 0.55f, up));
}

Light Backdrop::floorShade(const FloorLight& floor, const Vec3f& ray, float depth) const {
  const Vec3f point = view_.origin + depth * ray, d = point - floor.origin();
  const float far = std::sqrt(dot(d, d)) / reach_;
  const FloorLight::Light l = floor.at(point);
  const float ofSky = 0.46f * ambient_ * l.sky;
  const Light bright = (0.62f * l.sun) * product(sun_, l.glass) + Light{ofSky, ofSky, ofSky} + 0.62f * l.more;
  return mixed(product(bright, floor_), sky(ray), ramp(2.0f, 7.0f, far));
}

float Backdrop::bounce(const Vec3f& point) const {
  for (const FloorLight& f : floors_) {
    const FloorLight::Light l = f.at(point - dot(point - f.origin(), f.normal()) * f.normal());
    const auto all = [&](const FloorLight::Light& of) {
      return 0.57f * brightness(sun_) * of.sun + 0.43f * ambient_ * of.sky + 0.57f * brightness(of.more);
    };
    return all(f.open()) > 0 ? all(l) / all(f.open()) : 0;
  }
  return 1;
}

}  // namespace thaw
