#include "io/render/glass.hpp"

#include <algorithm>
#include <cmath>

namespace thaw {

namespace {

Vec3d toDouble(const Vec3f& a) { return {a.x, a.y, a.z}; }

/// Enters and leaves the box, in multiples of the direction; false if the ray misses it.
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

/// How much of the light is lost on the way, 0 to 1, and how bright what replaces it is.
struct Veil { double alpha = 0, bright = 0; };

/// Walks through all surfaces between `from` and `to` (metres along the unit direction): more is mirrored where they are seen edge on (Schlick 1994).
Veil walk(const SignedDistance& shape, const Vec3d& origin, const Vec3d& direction, double from, double to, double step) {
  Veil veil;
  double through = 1, t = from, before = 1;
  for (int n = 0; n < 160 && t < to; n++) {
    Vec3d gradient;
    const Vec3d x = origin + t * direction;
    const double d = shape.distance(x, nullptr);
    if (n > 0 && (d < 0) != (before < 0)) {
      shape.distance(x, &gradient);
      const double facing = std::abs(dot(gradient, direction)), mirrored = 0.05 + 0.75 * std::pow(1 - facing, 4);
      const double shine = 0.62 + 0.38 * std::max(0.0, gradient.z);
      veil.bright += through * mirrored * shine;
      through *= 1 - mirrored;
    }
    before = d;
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
    if (!std::isfinite(box.max.x - box.min.x) || !std::isfinite(box.max.y - box.min.y) || !std::isfinite(box.max.z - box.min.z)) continue;
    const Vec3d size = box.max - box.min, origin = toDouble(view.origin) - glass.move;
    const double step = 2e-3 * length(size);
    for (int y = 0; y < image.height; y++)
      for (int x = 0; x < image.width; x++) {
        const std::size_t sample = static_cast<std::size_t>(y * samples) * buffer.width + static_cast<std::size_t>(x) * samples;
        const Vec3d ray = toDouble(view.ray(static_cast<float>((x + 0.5) * samples), static_cast<float>((y + 0.5) * samples)));
        double from = 0, to = buffer.depth[sample];  // the ray has depth 1
        if (!clipToBox(origin, ray, box, from, to)) continue;
        const double scale = length(ray);
        const Veil veil = walk(*glass.shape, origin, ray / scale, from * scale, to * scale, step);
        if (veil.alpha <= 0) continue;
        const auto grey = static_cast<std::uint8_t>(std::lround(255 * std::min(1.0, veil.bright / veil.alpha)));
        mix(image, x, y, {grey, grey, grey}, veil.alpha);
      }
  }
}

}  // namespace thaw
