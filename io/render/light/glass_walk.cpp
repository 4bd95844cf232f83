// SPDX-License-Identifier: Apache-2.0
#include "io/render/light/glass_walk.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace thaw {

namespace {

/// Clips the ray to the box, in multiples of the direction; false if the ray misses it.
bool clipToBox(const Vec3d& origin, const Vec3d& direction, const Bounds& box, double& from, double& to) {
  for (int a = 0; a < 3; a++) {
    double t0 = (box.min[a] - origin[a]) / direction[a], t1 = (box.max[a] - origin[a]) / direction[a];
    if (std::isnan(t0) || std::isnan(t1)) continue;  // parallel to a side and on it
    if (t0 > t1) std::swap(t0, t1);
    from = std::max(from, t0);
    to = std::min(to, t1);
  }
  return from < to;
}

struct Ray {
  Vec3d origin, direction;  // unit direction
};

/// Returns the normal at the surface between two points of a ray, by bisection, since it jumps at edges.
Vec3d normalWhereCrossed(const SignedDistance& shape, const Ray& ray, double from, double to) {
  const bool inside = shape.distance(ray.origin + from * ray.direction) < 0;
  for (int n = 0; n < 8; n++) {
    const double middle = 0.5 * (from + to);
    ((shape.distance(ray.origin + middle * ray.direction) < 0) == inside ? from : to) = middle;
  }
  Vec3d gradient;
  shape.distance(ray.origin + (inside ? to : from) * ray.direction, &gradient);
  return gradient;
}

}  // namespace

GlassWalk::GlassWalk(const GlassHint& glass)
    : glass_(glass), box_(glass.shape->bounds()), back_(transpose(glass.turn)), up_(back_ * Vec3d{0, 0, 1}) {
  const Vec3d size = box_.max - box_.min;
  step_ = 2e-3 * length(size);
  centre_ = glass.move + glass.turn * (0.5 * (box_.min + box_.max));
  radius_ = 0.5 * length(size) + step_;
  box_ = {box_.min - Vec3d{step_, step_, step_}, box_.max + Vec3d{step_, step_, step_}};
}

GlassLayer GlassWalk::along(const Vec3d& origin, const Vec3d& direction, double reach) const {
  const Vec3d start = back_ * (origin - glass_.move), ray = back_ * direction;
  double from = 0, to = reach;
  if (!clipToBox(start, ray, box_, from, to)) return {};
  const double scale = length(ray);
  return walk(start, ray / scale, from * scale, to * scale);
}

/// Marches through all surfaces between `from` and `to` (m along the ray). Walls thinner than step_ may be
/// missed.
GlassLayer GlassWalk::walk(const Vec3d& origin, const Vec3d& direction, double from, double to) const {
  const SignedDistance& shape = *glass_.shape;
  const Ray ray{origin, direction};
  GlassLayer veil;
  double through = 1, t = from, last = from, before = 1;
  for (int n = 0; n < 160 && t < to; n++) {
    const double d = shape.distance(ray.origin + t * ray.direction, nullptr);
    if (n > 0 && (d < 0) != (before < 0)) {
      const Vec3d gradient = normalWhereCrossed(shape, ray, last, t);
      const double facing = std::abs(dot(gradient, ray.direction)),
                   mirrored = 0.05 + 0.75 * std::pow(1 - facing, 4);
      const double shine = 0.62 + 0.38 * std::max(0.0, dot(gradient, up_));
      veil.bright += through * mirrored * shine;
      veil.faces++;
      through *= 1 - mirrored;
    }
    before = d;
    last = t;
    t += std::max(std::abs(d), step_);
  }
  veil.alpha = 1 - through;
  return veil;
}

Light GlassWalk::tintOf(int faces) const {
  Light tint{1, 1, 1};
  for (int c = 0; c < 3; c++) tint[c] = std::pow(glass_.colour[c], 0.25f * static_cast<float>(faces));
  return tint;
}

std::vector<GlassWalk> glassWalks(const RenderStyle& style) {
  std::vector<GlassWalk> walks;
  for (const GlassHint& glass : style.glasses) {
    const Bounds box = glass.shape->bounds();
    if (std::isfinite(length(box.max - box.min))) walks.emplace_back(glass);
  }
  return walks;
}

GlassShade::GlassShade(const std::vector<GlassWalk>& glasses, const std::vector<Vec3f>& directions,
                       float spread)
    : glasses_(glasses), directions_(directions), spread_(std::tan(static_cast<double>(spread))) {
  for (const Vec3f& d : directions) middle_ += wide(d);
  middle_ = normalized(middle_);
}

Light GlassShade::at(const Vec3f& point) const {
  Light all{1, 1, 1};
  const Vec3d x = wide(point);
  for (const GlassWalk& glass : glasses_) {
    const Vec3d d = glass.centre() - x;
    const double ahead = dot(d, middle_), r = glass.radius() + spread_ * std::max(0.0, ahead);
    if (ahead < -glass.radius() || dot(d, d) - ahead * ahead > r * r) continue;
    Light sum{};
    for (const Vec3f& direction : directions_) {
      const GlassLayer layer = glass.along(x, wide(direction), std::numeric_limits<double>::max());
      sum += static_cast<float>(1 - layer.alpha) * glass.tintOf(layer.faces);
    }
    const float part = 1 / static_cast<float>(directions_.size());
    all = part * product(all, sum);
  }
  return all;
}

}  // namespace thaw
