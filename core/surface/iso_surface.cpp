#include "core/surface/iso_surface.hpp"

#include <algorithm>

#include "core/surface/update_surface.hpp"

namespace thaw {

FieldHere colourAt(const World& w, const SurfaceTools& t, std::uint64_t component, const Vec3d& x) {
  const SurfaceParticles& p = w.surface.particles;
  const double h = w.surface.particleSupport, h2 = h * h;
  FieldHere c;
  const double perNear2 = 1 / (nearSupport * nearSupport * w.scene.spacing * w.scene.spacing);
  double mean = 0, near = 0;
  forRowsAround(t.relax.particleBins, x, x, h, [&](std::uint32_t j, const Vec3d& at) {
    const Vec3d d = x - at;
    const double r2 = dot(d, d), u = 1 - r2 / h2, n = std::max(0.0, 1 - r2 * perNear2);
    if (!(u > 0) || p.component[j] != component) return;
    const double volume = static_cast<double>(t.relax.particle[4 * j + 3]);  // over that of the lattice sum
    c.value += volume * u * u * u;
    near += n * n * n;
    mean += static_cast<double>(t.relax.particleColour[j]) * u * u * u;
    c.gradient -= d * (6 / h2 * volume * u * u);
  });
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
