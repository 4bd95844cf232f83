#include "core/surface/iso_surface.hpp"

#include <algorithm>

#include "core/surface/update_surface.hpp"

namespace thaw {

FieldHere colourAt(const World& w, const SurfaceTools& t, std::uint64_t component, const Vec3d& x) {
  const double h = w.surface.particleSupport, h2 = h * h, back2 = 1 / h2, near2 = nearSupport * nearSupport * w.scene.spacing * w.scene.spacing, backNear2 = 1 / near2;
  FieldHere c;
  double mean = 0, near = 0;
  Vec3d gradient{};
  const Bins& bins = t.relax.particleBins;
  forBinsAround(bins, x, x, h, [&](std::size_t bin) {
    for (std::uint32_t k = bins.first[bin]; k < bins.first[bin + 1]; k++) {
      const FieldPoint& p = t.relax.field[k];
      const Vec3d d = x - p.at;
      const double r2 = dot(d, d);
      if (r2 >= h2 || p.component != component) continue;
      const double u = 1 - r2 * back2, u2 = u * u, v2 = p.volume * u2;
      c.value += v2 * u;
      mean += p.smooth * u2 * u;
      gradient -= v2 * d;
      if (r2 >= near2) continue;
      const double n = 1 - r2 * backNear2;
      near += n * n * n;
    }
  });
  c.gradient = (6 * back2) * gradient;
  if (c.value > 0) c.tight = near < nearFull ? 0.5 : 1, c.level = tightened(t.relax.level.level(mean / c.value), near) * w.scene.surface.isoLevel / 0.5;
  return c;
}

bool ontoIsoSurface(const World& w, const SurfaceTools& t, std::uint64_t component, const Vec3d& start, double most, SurfacePoint& found) {
  const double longest = 0.5 * w.scene.spacing, enough = 0.01 * w.surface.spacing;
  Vec3d x = start;
  for (int k = 0; k < 12; k++) {
    const FieldHere c = colourAt(w, t, component, x);
    const double slope = length(c.gradient);
    if (!(slope * w.surface.particleSupport > 0.05 * c.level && c.value > 0)) return false;
    const double step = std::clamp(c.tight * (c.level - c.value) / slope, -longest, longest);
    x += c.gradient * (step / slope);
    if (dot(x - start, x - start) > most * most) return false;
    if (std::abs(step) > enough) continue;
    found = {x, c.gradient * (-1 / slope)};
    return true;
  }
  return false;
}

}  // namespace thaw
