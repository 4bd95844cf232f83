#include "io/render/lights.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace thaw {

namespace {

Vec3f unit(const Vec3f& a) {
  const float l = std::sqrt(dot(a, a));
  return l > 0 ? a / l : a;
}
Vec3f toFloat(const Vec3d& a) { return {static_cast<float>(a.x), static_cast<float>(a.y), static_cast<float>(a.z)}; }

constexpr int skyDirections = 24;

}  // namespace

Lights makeLights(const Discs& spheres, const View& view) {
  Lights lights;
  double sum = 0;
  for (std::size_t i = 0; i < spheres.positions.size(); i++) sum += spheres.radius(i);
  lights.radius = spheres.positions.empty() ? 0 : static_cast<float>(sum / static_cast<double>(spheres.positions.size()));
  Vec3f level{view.forward.x, view.forward.y, 0};
  level = dot(level, level) > 1e-6f ? unit(level) : unit({view.up.x, view.up.y, 0});
  lights.sun = makeDepthMap(spheres, unit(-0.62f * view.right - 0.52f * level + Vec3f{0, 0, 0.95f}), 3.5f, 2048);
  // Fibonacci's spiral: even over the half sphere, from nearly level to nearly straight up.
  for (int k = 0; k < skyDirections; k++) {
    const float z = 0.06f + 0.93f * (static_cast<float>(k) + 0.5f) / skyDirections, s = std::sqrt(1 - z * z);
    const float angle = static_cast<float>(k * std::numbers::pi * (3 - std::sqrt(5.0)));
    lights.sky.push_back(makeDepthMap(spheres, {s * std::cos(angle), s * std::sin(angle), z}, 1.3f, 512));
  }
  return lights;
}

float skyLight(const Lights& lights, const Vec3f& point, const Vec3f& normal) {
  float light = 0, full = 0, open = 0;
  const Vec3f from = point + (0.5f * lights.radius) * normal;
  for (const DepthMap& map : lights.sky) {
    const float facing = dot(normal, map.toLight) + 0.15f;  // a little round the edge, as a sky is
    full += map.toLight.z + 0.15f;
    if (facing <= 0) continue;
    const float visible = map.visible(from, 1.4f * lights.radius, 0);
    light += facing * visible;
    open += visible;
  }
  const float bounce = 0.2f * (1 - normal.z) * (0.5f + open / static_cast<float>(lights.sky.size()));
  return light / full + bounce;
}

float sunLight(const Lights& lights, const Vec3f& point, const Vec3f& normal, int taps) {
  const float facing = dot(normal, lights.sun.toLight);
  if (facing <= 0) return 0;
  return facing * lights.sun.visible(point + (0.6f * lights.radius) * normal, 1.2f * lights.radius, taps);
}

FloorLight::FloorLight(const Lights& lights, const FloorHint& floor, const Vec3f& centre, float reach) : reach_(reach) {
  normal_ = toFloat(floor.normal);
  origin_ = centre - dot(centre - toFloat(floor.point), normal_) * normal_;
  u_ = unit(cross(normal_, std::abs(normal_.z) < 0.9f ? Vec3f{0, 0, 1} : Vec3f{1, 0, 0}));
  v_ = cross(normal_, u_);
  const float sunFacing = std::max(0.0f, dot(normal_, lights.sun.toLight));
  open_ = {sunFacing, 0};
  float full = 0;
  for (const DepthMap& map : lights.sky) {
    open_.sky += std::max(0.0f, dot(normal_, map.toLight) + 0.15f);
    full += map.toLight.z + 0.15f;
  }
  open_.sky /= full;
  table_.resize(static_cast<std::size_t>(side_) * side_);
  for (int j = 0; j < side_; j++)
    for (int i = 0; i < side_; i++) {
      const float a = (2 * (static_cast<float>(i) + 0.5f) / side_ - 1) * reach_, b = (2 * (static_cast<float>(j) + 0.5f) / side_ - 1) * reach_;
      const Vec3f p = origin_ + a * u_ + b * v_;
      // No bias: particles do not reach into the floor by more than their radius.
      float sky = 0;
      for (const DepthMap& map : lights.sky) {
        const float facing = dot(normal_, map.toLight) + 0.15f;
        if (facing > 0) sky += facing * map.visible(p, 0, 3);
      }
      table_[static_cast<std::size_t>(j) * side_ + i] = {sunFacing > 0 ? sunFacing * lights.sun.visible(p, 0, 4) : 0, sky / full};
    }
}

FloorLight::Light FloorLight::at(const Vec3f& point) const {
  const Vec3f d = point - origin_;
  const float x = (dot(d, u_) / reach_ + 1) * 0.5f * side_ - 0.5f, y = (dot(d, v_) / reach_ + 1) * 0.5f * side_ - 0.5f;
  if (!(x > 0 && y > 0 && x < side_ - 1 && y < side_ - 1)) return open_;
  const int i = static_cast<int>(x), j = static_cast<int>(y);
  const float fx = x - static_cast<float>(i), fy = y - static_cast<float>(j);
  const Light* p = &table_[static_cast<std::size_t>(j) * side_ + i];
  const auto between = [&](float Light::*m) {
    return (1 - fy) * ((1 - fx) * p[0].*m + fx * p[1].*m) + fy * ((1 - fx) * p[side_].*m + fx * p[side_ + 1].*m);
  };
  return {between(&Light::sun), between(&Light::sky)};
}

}  // namespace thaw
