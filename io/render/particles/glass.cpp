// SPDX-License-Identifier: Apache-2.0
#include "io/render/particles/glass.hpp"

#include <algorithm>
#include <cmath>

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

/// Opacity of glass along a ray, 0 to 1, and brightness of its reflection.
struct GlassLayer {
  double alpha = 0, bright = 0;
};

struct Ray {
  Vec3d origin, direction;
};  // unit direction

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

/// Marches through all surfaces between `from` and `to` (m along the ray); reflection grows at grazing angles
/// (S94). `up` is the direction of light; `step` (m) is the thickness below which walls may be
/// missed.
GlassLayer walk(const SignedDistance& shape, const Ray& ray, double from, double to, const Vec3d& up,
                double step) {
  GlassLayer veil;
  double through = 1, t = from, last = from, before = 1;
  for (int n = 0; n < 160 && t < to; n++) {
    const double d = shape.distance(ray.origin + t * ray.direction, nullptr);
    if (n > 0 && (d < 0) != (before < 0)) {
      const Vec3d gradient = normalWhereCrossed(shape, ray, last, t);
      const double facing = std::abs(dot(gradient, ray.direction)),
                   mirrored = 0.05 + 0.75 * std::pow(1 - facing, 4);
      const double shine = 0.62 + 0.38 * std::max(0.0, dot(gradient, up));
      veil.bright += through * mirrored * shine;
      through *= 1 - mirrored;
    }
    before = d;
    last = t;
    t += std::max(std::abs(d), step);
  }
  veil.alpha = 1 - through;
  return veil;
}

}  // namespace

void drawGlasses(Image& image, const RenderStyle& style, const View& view, const DepthBuffer& buffer) {
  const int samples = buffer.width / image.width;
  for (const GlassHint& glass : style.glasses) {
    Bounds box = glass.shape->bounds();
    if (!std::isfinite(box.max.x - box.min.x) || !std::isfinite(box.max.y - box.min.y) ||
        !std::isfinite(box.max.z - box.min.z))
      continue;
    const Vec3d size = box.max - box.min, origin = transpose(glass.turn) * (wide(view.origin) - glass.move);
    const Vec3d up = transpose(glass.turn) * Vec3d{0, 0, 1};
    const double step = 2e-3 * length(size);
    // rays start outside of the surface
    box = {box.min - Vec3d{step, step, step}, box.max + Vec3d{step, step, step}};
    for (int y = 0; y < image.height; y++)
      for (int x = 0; x < image.width; x++) {
        const std::size_t sample = static_cast<std::size_t>(y * samples) * buffer.width +
                                   static_cast<std::size_t>(x) * samples;
        const Vec3d ray = transpose(glass.turn) * wide(view.ray(static_cast<float>((x + 0.5) * samples),
                                                                static_cast<float>((y + 0.5) * samples)));
        double from = 0, to = buffer.depth[sample];  // the ray has depth 1
        if (!clipToBox(origin, ray, box, from, to)) continue;
        const double scale = length(ray);
        const GlassLayer veil = walk(*glass.shape, {origin, ray / scale}, from * scale, to * scale, up, step);
        if (veil.alpha <= 0) continue;
        const auto grey = static_cast<std::uint8_t>(
            std::lround(255 * std::min(1.0, veil.bright / veil.alpha)));
        mix(image, x, y, {grey, grey, grey}, veil.alpha);
      }
  }
}

}  // namespace thaw
